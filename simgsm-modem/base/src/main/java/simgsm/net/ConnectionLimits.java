package simgsm.net;

import java.net.InetAddress;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Limits of a port's connections, in all and per remote address. */
public final class ConnectionLimits {
    private static final int MOST_KNOWN = 10_000;

    private final int most;
    private final int mostPerAddress;
    private final int reserved;
    private final Set<InetAddress> known = new HashSet<>();
    private final Map<InetAddress, Integer> remote = new HashMap<>();
    private int open;

    /** @param most in all; @param mostPerAddress per address other than loopback */
    public ConnectionLimits(int most, int mostPerAddress) {
        this(most, mostPerAddress, 0);
    }

    /** @param reserved part of {@code most} for loopback and proven addresses */
    public ConnectionLimits(int most, int mostPerAddress, int reserved) {
        this.most = most;
        this.mostPerAddress = mostPerAddress;
        this.reserved = reserved;
    }

    /** A peer at this address has proven itself: its next connections may use the reserved places. */
    public void proven(InetAddress address) {
        if (known.size() < MOST_KNOWN) {
            known.add(address);
        }
    }

    /** Counts one more connection, if the limits allow it. */
    boolean admit(InetAddress address) {
        boolean isRemote = !address.isLoopbackAddress();
        int places = isRemote && !known.contains(address) ? most - reserved : most;
        if (open >= places || isRemote && remote.getOrDefault(address, 0) == mostPerAddress) {
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
