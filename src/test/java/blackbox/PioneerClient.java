package blackbox;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** A small P2OS client, written from the protocol's description alone. */
final class PioneerClient implements AutoCloseable {
    static final int ENABLE = 4;
    static final int SETO = 7;
    static final int MOVE = 8;
    static final int VEL = 11;
    static final int DHEAD = 13;
    static final int CONFIG = 18;

    private static final double MILLIMETERS_PER_UNIT = 0.485;
    private static final double DEGREES_PER_UNIT = 360 / 4096.0;
    private static final int PATIENCE_PACKETS = 600;

    /** What a robot says of itself ten times a second. */
    record Information(
            boolean moving, double x, double y, double heading, boolean stalled, int frontBumpers, int[] sonars) {}

    private final Socket socket;
    private final DataInputStream in;
    private String name = "";

    PioneerClient(String port) throws IOException {
        socket = new Socket("127.0.0.1", Integer.parseInt(port));
        socket.setSoTimeout(20_000);
        in = new DataInputStream(socket.getInputStream());
        for (int step = 0; step <= 2; step++) {
            send((byte) step);
            byte[] answer = packet();
            if (answer[0] != step) {
                throw new AssertionError("synchronisation " + step + " was answered by " + answer[0]);
            }
            name = new String(answer, StandardCharsets.US_ASCII).substring(1).replace('\0', '/');
        }
        command(1, 1);
    }

    /** Name, class and subclass, a slash behind each. */
    String name() {
        return name;
    }

    void command(int number, int argument) throws IOException {
        int size = Math.abs(argument);
        send((byte) number, (byte) (argument < 0 ? 0x1B : 0x3B), (byte) size, (byte) (size >> 8));
    }

    void send(byte... data) throws IOException {
        int sum = 0;
        for (int i = 0; i + 1 < data.length; i += 2) {
            sum += (data[i] & 0xFF) << 8 | data[i + 1] & 0xFF;
        }
        if (data.length % 2 == 1) {
            sum ^= data[data.length - 1] & 0xFF;
        }
        ByteBuffer packet = ByteBuffer.allocate(data.length + 5);
        packet.put((byte) 0xFA).put((byte) 0xFB).put((byte) (data.length + 2)).put(data);
        socket.getOutputStream().write(packet.putShort((short) sum).array());
    }

    private byte[] packet() throws IOException {
        if (in.readUnsignedShort() != 0xFAFB) {
            throw new AssertionError("a packet begins with FA FB");
        }
        byte[] data = new byte[in.readUnsignedByte() - 2];
        in.readFully(data);
        in.readUnsignedShort();
        return data;
    }

    /** The next information packet; each is answered by a pulse. */
    Information information() throws IOException {
        byte[] data = packetWithId(0x32, 0x33);
        send((byte) 0);
        ByteBuffer sip = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        int[] sonars = new int[sip.get(19)];
        for (int i = 0; i < sonars.length; i++) {
            sonars[sip.get(20 + 3 * i)] = sip.getShort(21 + 3 * i) & 0xFFFF;
        }
        return new Information(
                data[0] == 0x33,
                // signed, as far as 15 bits go
                (short) (sip.getShort(1) << 1) / 2 * MILLIMETERS_PER_UNIT,
                (short) (sip.getShort(3) << 1) / 2 * MILLIMETERS_PER_UNIT,
                sip.getShort(5) * DEGREES_PER_UNIT,
                (data[12] & data[13] & 1) != 0,
                data[13] >> 1 & 0x1F,
                sonars);
    }

    /** The next packet of that kind. */
    byte[] packetWithId(int... ids) throws IOException {
        for (int i = 0; i < PATIENCE_PACKETS; i++) {
            byte[] data = packet();
            for (int id : ids) {
                if ((data[0] & 0xFF) == id) {
                    return data;
                }
            }
        }
        throw new AssertionError("no such packet came");
    }

    /** Waits until the robot has set out and come to rest again. */
    Information untilItHasMoved() throws IOException {
        Information now = information();
        for (int i = 0; i < PATIENCE_PACKETS && !now.moving(); i++) {
            now = information();
        }
        for (int i = 0; i < PATIENCE_PACKETS && now.moving(); i++) {
            now = information();
        }
        return now;
    }

    /** Says goodbye and waits until the robot has hung up. */
    void leave() throws IOException {
        send((byte) 2);
        byte[] rest = new byte[512];
        while (in.read(rest) >= 0) {
            continue;
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
