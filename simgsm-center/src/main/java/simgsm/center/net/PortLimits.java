package simgsm.center.net;

/**
 * Maximum numbers of connections.
 *
 * @param terminals in total
 * @param terminalsPerAddress from each remote address; permits a class behind one NAT
 * @param applications SMPP sessions in total
 * @param applicationsPerAddress from each remote address
 */
public record PortLimits(int terminals, int terminalsPerAddress, int applications, int applicationsPerAddress) {
    public static final PortLimits STANDARD = new PortLimits(20_000, 500, 5_000, 2_000);
    /** Maximum of each limit; the process may run out of file descriptors earlier. */
    public static final int LARGEST = 200_000;
}
