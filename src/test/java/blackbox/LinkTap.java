package blackbox;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/** A TCP relay between a terminal and its network, which passes whole IPA frames on and keeps the speech of both directions. */
final class LinkTap implements AutoCloseable {
    private static final int SPEECH = 0xe1;

    private final ServerSocket server;
    private final String host;
    private final int port;
    private final List<Socket> sockets = new ArrayList<>();
    private final List<Speech> fromTerminal = new ArrayList<>();
    private final List<Speech> toTerminal = new ArrayList<>();

    /**
     * One RTP packet.
     *
     * @param sequence 0 to 65535
     * @param payload 160 octets of A-law or 33 of GSM 06.10
     */
    record Speech(int source, int sequence, byte[] payload) {
        private static Speech of(byte[] rtp) {
            ByteBuffer in = ByteBuffer.wrap(rtp);
            byte[] payload = new byte[rtp.length - 12];
            in.get(12, payload);
            return new Speech(in.getInt(8), in.getShort(2) & 0xffff, payload);
        }
    }

    /** @param network where the connections go, HOST:PORT */
    LinkTap(String network) throws IOException {
        host = network.substring(0, network.lastIndexOf(':'));
        port = Integer.parseInt(network.substring(network.lastIndexOf(':') + 1));
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        run("accepting", this::accept);
    }

    /** Where the terminal connects. */
    String address() {
        return "127.0.0.1:" + server.getLocalPort();
    }

    synchronized List<Speech> fromTerminal() {
        return List.copyOf(fromTerminal);
    }

    synchronized List<Speech> toTerminal() {
        return List.copyOf(toTerminal);
    }

    private interface Work {
        void run() throws IOException;
    }

    private static void run(String name, Work work) {
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } catch (IOException ended) {
                        // The other direction and the programs notice it by themselves.
                    }
                },
                "tap, " + name);
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() throws IOException {
        while (true) {
            Socket terminal = server.accept();
            Socket network = new Socket(host, port);
            synchronized (this) {
                sockets.add(terminal);
                sockets.add(network);
            }
            run("from the terminal", () -> pass(terminal, network, fromTerminal));
            run("to the terminal", () -> pass(network, terminal, toTerminal));
        }
    }

    private void pass(Socket from, Socket to, List<Speech> kept) throws IOException {
        to.setTcpNoDelay(true);
        try (from;
                to) {
            DataInputStream in = new DataInputStream(from.getInputStream());
            OutputStream out = to.getOutputStream();
            while (true) {
                int length = in.readUnsignedShort();
                int stream = in.readUnsignedByte();
                byte[] payload = in.readNBytes(length);
                if (stream == SPEECH) {
                    synchronized (this) {
                        kept.add(Speech.of(payload));
                    }
                }
                out.write(ByteBuffer.allocate(3 + payload.length)
                        .putShort((short) length)
                        .put((byte) stream)
                        .put(payload)
                        .array());
            }
        }
    }

    @Override
    public synchronized void close() throws IOException {
        server.close();
        for (Socket socket : sockets) {
            socket.close();
        }
    }
}
