package simgsm.gateway;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import simgsm.console.FatalError;
import simgsm.station.StationThread;
import simgsm.web.WebPort;
import simgsm.web.WebSocketPath;

/** A running gateway: the users, the thread that owns them, and the port of their pages. */
final class Gateway implements AutoCloseable {
    private final StationThread thread = new StationThread("gateway", cause -> FatalError.end(GatewayMain.NAME, cause));
    private final WebUsers users;
    private final WebPort port;
    private final String key;

    /** @throws IOException if the port cannot be opened */
    Gateway(GatewaySettings settings, Consumer<GatewayEvent> listener) throws IOException {
        users = new WebUsers(thread, settings, listener);
        key = settings.key();
        WebSocketPath phone = new WebSocketPath(
                "/phone",
                PhoneSocket.PROTOCOL,
                false,
                PhoneSocket.MOST_OCTETS,
                socket -> new PhoneSocket(socket, users));
        port = new WebPort(
                thread::listen,
                new InetSocketAddress(settings.bind(), settings.web()),
                new GatewayPages(this, new RobotPages(settings.robots())),
                List.of(phone),
                true);
    }

    void start() {
        thread.start();
        port.start();
    }

    int webPort() {
        return port.port();
    }

    /** The link for pupils. */
    String link() {
        return port.url() + "#" + key;
    }

    WebUsers users() {
        return users;
    }

    /** Runs a question on the owner thread. */
    <T> T ask(Callable<T> question) {
        return thread.ask(question);
    }

    /** Ends the calls, detaches the users and ends the thread. */
    @Override
    public void close() {
        thread.execute(() -> users.all().forEach(user -> user.end(CloseCode.GOING_AWAY, "the gateway ends")));
        port.close();
        thread.close();
    }
}
