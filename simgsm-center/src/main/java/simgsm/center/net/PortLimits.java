package simgsm.center.net;

/**
 * Connections that the centre accepts.
 *
 * @param terminals in all
 * @param terminalsPerAddress from each remote address; permits a class behind one NAT
 * @param applications SMPP sessions in all
 * @param applicationsPerAddress from each remote address
 */
public record PortLimits(int terminals, int terminalsPerAddress, int applications, int applicationsPerAddress) {
    public static final PortLimits STANDARD = new PortLimits(20_000, 500, 5_000, 2_000);
    /** Of each limit; the file descriptors of the process may end before it. */
    public static final int LARGEST = 200_000;
}
