package simgsm.center.smsc;

/** Limits of caches by the size of the heap. */
public final class HeapShare {
    /** Share of the heap for each kind of object. */
    private static final double SHARE = 0.02;

    private HeapShare() {}

    /** Number of objects of this size in 2 % of this program's heap, at most {@code most}. */
    public static int count(int most, int octets) {
        return count(most, octets, Runtime.getRuntime().maxMemory());
    }

    static int count(int most, int octets, long heapOctets) {
        return (int) Math.min(most, SHARE * heapOctets / octets);
    }
}
