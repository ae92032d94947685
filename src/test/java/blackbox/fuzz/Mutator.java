package blackbox.fuzz;

import java.util.Arrays;
import java.util.SplittableRandom;
import simgsm.octets.Octets;

/** Mutates octets by 1 to 4 changes of the kinds that faulty programs and links cause. */
final class Mutator {
    private static final int MOST_CHANGES = 4;
    private static final int MOST_INSERTED = 12;
    /** Values at the limits of lengths and signs. */
    private static final byte[] EDGES = {0, 1, 0x0f, 0x10, 0x7f, (byte) 0x80, (byte) 0xf0, (byte) 0xfe, (byte) 0xff};

    private final SplittableRandom random;

    Mutator(SplittableRandom random) {
        this.random = random;
    }

    /** A changed copy. @param mostOctets greatest length of the result */
    byte[] mutate(byte[] octets, int mostOctets) {
        byte[] mutated = octets.clone();
        int changes = 0;
        do {
            mutated = change(mutated);
            changes++;
        } while (changes < MOST_CHANGES && random.nextInt(3) == 0);
        return mutated.length > mostOctets ? Arrays.copyOf(mutated, mostOctets) : mutated;
    }

    private byte[] change(byte[] octets) {
        if (octets.length == 0) {
            return inserted(octets, 0);
        }
        int place = random.nextInt(octets.length);
        switch (random.nextInt(8)) {
            case 0 -> octets[place] ^= (byte) (1 << random.nextInt(8));
            case 1 -> octets[place] = (byte) random.nextInt();
            case 2 -> octets[place] = EDGES[random.nextInt(EDGES.length)];
            case 3 -> octets[place] += (byte) (random.nextBoolean() ? 1 : -1);
            case 4 -> {
                return Arrays.copyOf(octets, place);
            }
            case 5 -> {
                return removed(octets, place);
            }
            case 6 -> {
                return repeated(octets, place);
            }
            default -> {
                return inserted(octets, place);
            }
        }
        return octets;
    }

    private byte[] removed(byte[] octets, int place) {
        int count = 1 + random.nextInt(Math.min(MOST_INSERTED, octets.length - place));
        byte[] less = new byte[octets.length - count];
        System.arraycopy(octets, 0, less, 0, place);
        System.arraycopy(octets, place + count, less, place, less.length - place);
        return less;
    }

    private byte[] inserted(byte[] octets, int place) {
        byte[] added = new byte[1 + random.nextInt(MOST_INSERTED)];
        random.nextBytes(added);
        return with(octets, place, added);
    }

    private byte[] repeated(byte[] octets, int place) {
        int count = 1 + random.nextInt(octets.length - place);
        return with(octets, place, Octets.range(octets, place, place + count));
    }

    private static byte[] with(byte[] octets, int place, byte[] added) {
        byte[] more = new byte[octets.length + added.length];
        System.arraycopy(octets, 0, more, 0, place);
        System.arraycopy(added, 0, more, place, added.length);
        System.arraycopy(octets, place, more, place + added.length, octets.length - place);
        return more;
    }

    /** The beginning of one array and the end of another. */
    byte[] splice(byte[] head, byte[] tail) {
        int kept = random.nextInt(head.length + 1);
        int from = random.nextInt(tail.length + 1);
        byte[] both = Arrays.copyOf(head, kept + tail.length - from);
        System.arraycopy(tail, from, both, kept, tail.length - from);
        return both;
    }
}
