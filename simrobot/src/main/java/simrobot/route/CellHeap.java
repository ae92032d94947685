package simrobot.route;

import java.util.Arrays;

/** A binary heap of cells with the cheapest first. Costs are 0 or more. */
final class CellHeap {
    /** The cost's bits, whose order is that of the costs, above the cell's number. */
    private long[] entries = new long[1024];

    private int size;

    boolean isEmpty() {
        return size == 0;
    }

    float leastCost() {
        return Float.intBitsToFloat((int) (entries[0] >>> 32));
    }

    void add(int cell, float cost) {
        if (size == entries.length) {
            entries = Arrays.copyOf(entries, 2 * size);
        }
        long entry = (long) Float.floatToIntBits(cost) << 32 | cell;
        int place = size++;
        while (place > 0 && entries[(place - 1) / 2] > entry) {
            entries[place] = entries[(place - 1) / 2];
            place = (place - 1) / 2;
        }
        entries[place] = entry;
    }

    /** Removes the cheapest cell. */
    int remove() {
        int cell = (int) entries[0];
        long last = entries[--size];
        int place = 0;
        for (int child = 1; child < size; child = 2 * place + 1) {
            if (child + 1 < size && entries[child + 1] < entries[child]) {
                child++;
            }
            if (entries[child] >= last) {
                break;
            }
            entries[place] = entries[child];
            place = child;
        }
        entries[place] = last;
        return cell;
    }
}
