package simrobot.p2os;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.Queue;

/** A P2OS client over a real socket. */
final class SocketClient implements AutoCloseable {
    private static final int PATIENCE_MILLIS = 20_000;

    private final Socket socket;
    private final Queue<byte[]> packets = new ArrayDeque<>();
    private final P2osPacketReader reader = new P2osPacketReader(packets::add);

    SocketClient(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(PATIENCE_MILLIS);
        socket.setTcpNoDelay(true);
    }

    static SocketClient opened(int port) throws IOException {
        SocketClient client = new SocketClient(port);
        client.open();
        return client;
    }

    void open() throws IOException {
        for (int step = 0; step <= 2; step++) {
            send(P2osCommand.packet(step));
            byte[] answer = packet();
            if (answer[0] != step) {
                throw new AssertionError("step " + step + " answered by " + answer[0]);
            }
        }
        send(P2osCommand.packet(P2osCommandNumber.OPEN, 1));
    }

    void send(byte[] bytes) throws IOException {
        socket.getOutputStream().write(bytes);
    }

    /** The next packet's data; null when the robot has hung up. */
    byte[] packet() throws IOException {
        InputStream in = socket.getInputStream();
        byte[] chunk = new byte[512];
        while (packets.isEmpty()) {
            int read;
            try {
                read = in.read(chunk);
            } catch (java.net.SocketTimeoutException e) {
                throw e;
            } catch (IOException reset) {
                return null;
            }
            if (read < 0) {
                return null;
            }
            reader.read(java.util.Arrays.copyOf(chunk, read), 0);
        }
        return packets.remove();
    }

    Sip sip() throws IOException {
        for (byte[] data = packet(); data != null; data = packet()) {
            if (data[0] == InformationPacket.STOPPED_ID || data[0] == InformationPacket.MOVING_ID) {
                return Sip.of(data);
            }
        }
        throw new AssertionError("the robot hung up");
    }

    boolean isHungUp() throws IOException {
        byte[] last = packet();
        while (last != null) {
            last = packet();
        }
        return true;
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
