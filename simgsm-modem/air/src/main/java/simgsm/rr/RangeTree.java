package simgsm.rr;

import java.util.ArrayList;
import java.util.List;

/**
 * The words W(1), W(2) ... of a range format (TS 44.018, annex J): a binary tree that halves the range at each frequency.
 * W(k) is 1 plus the frequency's place on the circle of its part of the range; its children are the words k + j and k + 2j,
 * where j is the highest power of 2 not above k. The first holds the far half of the circle and the second the near one. 0
 * ends the list.
 */
final class RangeTree {
    private RangeTree() {}

    /** Bits of W(index) in a range of 128 to 1024. */
    static int width(int range, int index) {
        return Integer.numberOfTrailingZeros(range / Integer.highestOneBit(index));
    }

    /** Number of words that this many bits hold. */
    static int room(int range, int bits) {
        int count = 0;
        int left = bits - width(range, 1);
        while (left >= 0) {
            count++;
            left -= width(range, count + 1);
        }
        return count;
    }

    /** The words, from index 1. @param offsets different numbers from 0 to less than range - 1 */
    static int[] words(int range, List<Integer> offsets) {
        int[] words = new int[offsets.size() + 1];
        place(words, 1, range - 1, offsets);
        return words;
    }

    private static void place(int[] words, int index, int circle, List<Integer> offsets) {
        if (offsets.isEmpty()) {
            return;
        }
        int half = (circle - 1) / 2;
        int pivot = pivot(circle, offsets);
        words[index] = pivot + 1;
        List<Integer> near = new ArrayList<>();
        List<Integer> far = new ArrayList<>();
        for (int offset : offsets) {
            int distance = Math.floorMod(offset - pivot - 1, circle);
            if (distance < half) {
                near.add(distance);
            } else if (offset != pivot) {
                far.add(distance - half);
            }
        }
        int power = Integer.highestOneBit(index);
        place(words, index + power, half, far);
        place(words, index + 2 * power, half, near);
    }

    /** The first offset with half of the others, rounded down, in the half circle after it. */
    private static int pivot(int circle, List<Integer> offsets) {
        for (int offset : offsets) {
            long near = offsets.stream()
                    .filter(other -> Math.floorMod(other - offset - 1, circle) < (circle - 1) / 2)
                    .count();
            if (near == (offsets.size() - 1) / 2) {
                return offset;
            }
        }
        throw new IllegalStateException("no offset halves " + offsets);
    }

    /** The offsets of words, from index 1; those after a 0 do not count. */
    static List<Integer> offsets(int range, int[] words) {
        List<Integer> offsets = new ArrayList<>();
        for (int index = 1; index < words.length && words[index] != 0; index++) {
            offsets.add(offset(range, words, index));
        }
        return offsets;
    }

    private static int offset(int range, int[] words, int of) {
        int offset = words[of] - 1;
        int index = of;
        for (int power = Integer.highestOneBit(of); power > 1; power /= 2) {
            boolean isFar = 2 * index < 3 * power;
            index -= isFar ? power / 2 : power;
            int circle = 2 * range / power - 1;
            offset = Math.floorMod(words[index] + offset + (isFar ? (circle - 1) / 2 : 0), circle);
        }
        return offset;
    }
}
