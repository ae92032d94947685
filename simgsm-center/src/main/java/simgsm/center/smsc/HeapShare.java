package simgsm.center.smsc;

/** Limits of what is remembered: a small heap remembers less. */
public final class HeapShare {
    /** Of the heap, for each kind of thing. */
    private static final double SHARE = 0.02;

    private HeapShare() {}

    /** How many things of this size take 2 % of this program's heap, at most {@code most}. */
    public static int count(int most, int octets) {
        return count(most, octets, Runtime.getRuntime().maxMemory());
    }

    static int count(int most, int octets, long heapOctets) {
        return (int) Math.min(most, SHARE * heapOctets / octets);
    }
}
