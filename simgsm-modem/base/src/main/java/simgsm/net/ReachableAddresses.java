package simgsm.net;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The addresses at which other machines reach a port of this one, the likeliest first. */
public final class ReachableAddresses {
    /** An address for documentation (RFC 5737), which selects the default route; nothing is sent. */
    private static final InetSocketAddress ELSEWHERE = new InetSocketAddress("192.0.2.1", 9);

    private ReachableAddresses() {}

    /** @param bound address of the port; the wildcard means all addresses of this machine */
    public static List<String> of(InetAddress bound) throws SocketException {
        if (!bound.isAnyLocalAddress()) {
            return List.of(bound.getHostAddress());
        }
        List<String> all = new ArrayList<>();
        for (NetworkInterface each : NetworkInterface.networkInterfaces().toList()) {
            if (each.isUp() && !each.isLoopback()) {
                each.inetAddresses()
                        .filter(Inet4Address.class::isInstance)
                        .map(InetAddress::getHostAddress)
                        .forEach(all::add);
            }
        }
        return inOrder(routed(), all);
    }

    /** The address of the default route first, before those of bridges and tunnels; without any, loopback. */
    static List<String> inOrder(Optional<String> routed, List<String> all) {
        List<String> ordered = Stream.concat(routed.filter(all::contains).stream(), all.stream())
                .distinct()
                .toList();
        return ordered.isEmpty() ? List.of(InetAddress.getLoopbackAddress().getHostAddress()) : ordered;
    }

    private static Optional<String> routed() {
        try (DatagramSocket socket = new DatagramSocket()) {
            socket.connect(ELSEWHERE);
            return Optional.of(socket.getLocalAddress().getHostAddress());
        } catch (IOException | UncheckedIOException e) {
            return Optional.empty(); // no way leads out
        }
    }
}
