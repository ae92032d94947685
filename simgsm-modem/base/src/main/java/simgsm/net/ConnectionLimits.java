package simgsm.net;

import java.net.InetAddress;
import java.util.HashMap;
import java.util.Map;

/** How many connections a port may have, in all and from each remote address. */
public final class ConnectionLimits {
    private final int most;
    private final int mostPerAddress;
    private final Map<InetAddress, Integer> remote = new HashMap<>();
    private int open;

    /** @param most in all; @param mostPerAddress from each address other than the loopback ones */
    public ConnectionLimits(int most, int mostPerAddress) {
        this.most = most;
        this.mostPerAddress = mostPerAddress;
    }

    /** Counts one more connection, if the limits allow it. */
    boolean admit(InetAddress address) {
        boolean isRemote = !address.isLoopbackAddress();
        if (open == most || isRemote && remote.getOrDefault(address, 0) == mostPerAddress) {
            return false;
        }
        open++;
        if (isRemote) {
            remote.merge(address, 1, Integer::sum);
        }
        return true;
    }

    /** An admitted connection has been closed. */
    void release(InetAddress address) {
        open--;
        remote.computeIfPresent(address, (same, count) -> count == 1 ? null : count - 1);
    }

    int open() {
        return open;
    }
}
