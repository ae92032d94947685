package simgsm.octets;

/** Copies of arrays of octets. */
public final class Octets {
    private Octets() {}

    /**
     * The octets from index {@code from} to before {@code to}, as {@code Arrays.copyOfRange} returns them.
     *
     * <p>Not {@code Arrays.copyOfRange}: the C2 compiler of JDK 17 (found with 17.0.15, not in 25) may replace a copy of at
     * most 8 octets made from its result by zeros. Decision 25 has the figures; {@code OctetsTest} shows it.
     */
    public static byte[] range(byte[] octets, int from, int to) {
        byte[] copy = new byte[to - from];
        System.arraycopy(octets, from, copy, 0, copy.length);
        return copy;
    }
}
