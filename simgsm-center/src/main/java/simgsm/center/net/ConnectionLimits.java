package simgsm.center.net;

import java.net.InetAddress;
import java.util.HashMap;
import java.util.Map;

/** How many connections are open, in all and from each address, and whether one more may come in. */
final class ConnectionLimits {
    private final int most;
    private final int mostPerAddress;
    private final Map<InetAddress, Integer> remote = new HashMap<>();
    private int open;

    /** @param most in all; @param mostPerAddress from each address beyond this machine */
    ConnectionLimits(int most, int mostPerAddress) {
        this.most = most;
        this.mostPerAddress = mostPerAddress;
    }

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

    /** One that was admitted has gone. */
    void left(InetAddress address) {
        open--;
        remote.computeIfPresent(address, (same, count) -> count == 1 ? null : count - 1);
    }

    int open() {
        return open;
    }
}
