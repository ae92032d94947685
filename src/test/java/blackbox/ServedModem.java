package blackbox;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** An {@link EmulatedModem} on a TCP port of this machine, in real time. One client at a time. */
public final class ServedModem implements AutoCloseable {
    private static final int TICK_MILLIS = 5;
    private static final int KEY_MILLIS = 150;

    /** Owns the modem. */
    private final ScheduledExecutorService owner = Executors.newSingleThreadScheduledExecutor();

    private final EmulatedModem modem;
    private ServerSocket server;
    private final int port;
    private volatile Socket client;

    public ServedModem() throws IOException {
        this(EmulatedModem.Family.SIM800);
    }

    ServedModem(EmulatedModem.Family family) throws IOException {
        modem = new EmulatedModem(family, this::toHost);
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        port = server.getLocalPort();
        serve(server);
        owner.scheduleAtFixedRate(() -> modem.advance(System.nanoTime()), 0, TICK_MILLIS, TimeUnit.MILLISECONDS);
    }

    private void toHost(byte[] octets) {
        Socket open = client;
        if (open != null) {
            try {
                OutputStream out = open.getOutputStream();
                out.write(octets);
                out.flush();
            } catch (IOException gone) {
                client = null;
            }
        }
    }

    private void serve(ServerSocket open) {
        Thread thread = new Thread(
                () -> {
                    while (!open.isClosed()) {
                        try (Socket accepted = open.accept()) {
                            accepted.setTcpNoDelay(true);
                            client = accepted;
                            read(accepted.getInputStream());
                        } catch (IOException ended) {
                            client = null;
                        }
                    }
                },
                "emulated modem");
        thread.setDaemon(true);
        thread.start();
    }

    private void read(InputStream in) throws IOException {
        byte[] buffer = new byte[1024];
        for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
            String octets = new String(buffer, 0, count, StandardCharsets.ISO_8859_1);
            owner.execute(() -> modem.received(octets));
        }
    }

    public String address() {
        return "127.0.0.1:" + port;
    }

    public int port() {
        return port;
    }

    /** Closes the port and the connection, as when the modem is unplugged. */
    void unplug() throws IOException {
        server.close();
        Socket open = client;
        if (open != null) {
            open.close();
        }
    }

    void plugIn() throws IOException {
        server = new ServerSocket();
        server.setReuseAddress(true);
        server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
        serve(server);
    }

    /** Something happens to the modem. */
    public void happens(Act act) {
        ask(() -> {
            act.to(modem);
            return null;
        });
    }

    /** What happens to a modem. */
    public interface Act {
        void to(EmulatedModem modem);
    }

    public void call(String from) {
        happens(there -> there.call(from));
    }

    public void hangUp() {
        happens(EmulatedModem::callerHangsUp);
    }

    public void message(String from, String text) {
        happens(there -> there.message(from, text));
    }

    /** Begins to press the keys. */
    public void press(String keys) {
        int millis = 0;
        for (char key : keys.replace(" ", "").toCharArray()) {
            owner.schedule(() -> modem.key(key), millis, TimeUnit.MILLISECONDS);
            millis += KEY_MILLIS;
        }
    }

    public String tonesSent() {
        return ask(modem.tonesSent::toString);
    }

    private <T> T ask(Callable<T> question) {
        try {
            return owner.submit(question).get();
        } catch (InterruptedException | ExecutionException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public void close() throws IOException {
        unplug();
        owner.shutdownNow();
    }
}
