package simgsm.web;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import simgsm.net.Acceptor;
import simgsm.net.Connection;

/**
 * Serves WebSockets and passes every other connection, octet by octet, to the JDK's HTTP server on a port of the
 * loopback address. The JDK's server cannot upgrade a connection (JDK-8368695).
 */
final class WebDoor implements Acceptor.Factory {
    private final InetSocketAddress pages;
    private final Map<String, WebSocketPath> paths;
    private final boolean admitsEveryHost;
    /** Clients of passed connections, by their port on the loopback address. */
    private final Map<Integer, InetSocketAddress> clients = new ConcurrentHashMap<>();

    /** @param admitsEveryHost see {@link WebPages} */
    WebDoor(InetSocketAddress pages, List<WebSocketPath> paths, boolean admitsEveryHost) {
        this.pages = pages;
        this.paths = paths.stream().collect(Collectors.toMap(WebSocketPath::path, Function.identity()));
        this.admitsEveryHost = admitsEveryHost;
    }

    @Override
    public Connection connection(Connection.Endpoint endpoint) {
        return new DoorConnection(endpoint, this);
    }

    InetSocketAddress pages() {
        return pages;
    }

    /** @throws RequestException if the handshake is refused */
    WebSocketPath path(HttpHead head) throws RequestException {
        WebSocketPath path = WebSocketHandshake.path(head, paths);
        if (!path.admitsEveryOrigin()) {
            String host = head.field("Host").orElse(null);
            if (!admitsEveryHost) {
                Origins.requireOwnHost(host);
            }
            Origins.requireSameOrigin(host, head.field("Origin").orElse(null));
        }
        return path;
    }

    /** The client behind a loopback address seen by the HTTP server. */
    InetSocketAddress client(InetSocketAddress seen) {
        return clients.getOrDefault(seen.getPort(), seen);
    }

    void passed(int port, InetSocketAddress client) {
        clients.put(port, client);
    }

    void ended(int port) {
        clients.remove(port);
    }
}
