package blackbox;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Queue;

/** An application at the centre's SMPP port, written from SMPP 3.4 alone: it knows nothing of the centre's own codec. */
final class SmppApplication implements AutoCloseable {
    private static final int BIND_TRANSCEIVER = 0x09;
    private static final int SUBMIT_SM = 0x04;
    private static final int DELIVER_SM = 0x05;
    private static final int UNBIND = 0x06;
    private static final int RESPONSE = 0x8000_0000;

    /** What a deliver_sm said. */
    record Delivery(String from, String to, boolean isReceipt, String text) {}

    private record Pdu(int command, int status, int sequence, byte[] body) {}

    private final String number;
    private final Socket socket;
    private final DataInputStream in;
    private final DataOutputStream out;
    private final Queue<Delivery> deliveries = new ArrayDeque<>();
    private int sequence;

    /** Connects and binds as the application that serves this number. */
    SmppApplication(int port, String systemId, String password, String number) throws IOException {
        this.number = number;
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(RunningProgram.PATIENCE_SECONDS * 1_000);
        in = new DataInputStream(socket.getInputStream());
        out = new DataOutputStream(socket.getOutputStream());
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        text(body, systemId);
        text(body, password);
        text(body, "");
        body.write(0x34);
        body.write(0);
        body.write(0);
        text(body, number);
        check(request(BIND_TRANSCEIVER, body.toByteArray()));
    }

    private static void check(Pdu response) throws IOException {
        if (response.status != 0) {
            throw new IOException("status " + response.status + " answers command " + (response.command ^ RESPONSE));
        }
    }

    private static void text(ByteArrayOutputStream body, String text) {
        body.writeBytes(text.getBytes(StandardCharsets.ISO_8859_1));
        body.write(0);
    }

    /** Sends a text of the GSM alphabet's plain letters and digits; returns the message id. */
    String submit(String to, String text, boolean wantsReceipt) throws IOException {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        text(body, "");
        address(body, number);
        address(body, to);
        body.writeBytes(new byte[] {0, 0, 0});
        text(body, "");
        text(body, "");
        body.writeBytes(new byte[] {(byte) (wantsReceipt ? 1 : 0), 0, 0, 0, (byte) text.length()});
        body.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
        Pdu response = request(SUBMIT_SM, body.toByteArray());
        check(response);
        return cString(response.body, 0);
    }

    /** Sends a text of plain letters and digits as message_payload; returns the status that answers it. */
    int submitPayload(String to, String text) throws IOException {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        text(body, "");
        address(body, number);
        address(body, to);
        body.writeBytes(new byte[] {0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        body.writeBytes(new byte[] {0x04, 0x24, (byte) (text.length() >> 8), (byte) text.length()});
        body.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
        return request(SUBMIT_SM, body.toByteArray()).status;
    }

    private static void address(ByteArrayOutputStream body, String digits) {
        body.write(1);
        body.write(1);
        text(body, digits);
    }

    /** The next delivery of this kind. */
    Delivery await(boolean receipt) throws IOException {
        while (true) {
            while (deliveries.isEmpty()) {
                take(read());
            }
            Delivery next = deliveries.remove();
            if (next.isReceipt == receipt) {
                return next;
            }
        }
    }

    void unbind() throws IOException {
        check(request(UNBIND, new byte[0]));
    }

    private Pdu request(int command, byte[] body) throws IOException {
        int number = ++sequence;
        write(new Pdu(command, 0, number, body));
        while (true) {
            Pdu pdu = read();
            if (pdu.command == (command | RESPONSE) && pdu.sequence == number) {
                return pdu;
            }
            take(pdu);
        }
    }

    private void take(Pdu pdu) throws IOException {
        if (pdu.command != DELIVER_SM) {
            return;
        }
        int at = end(pdu.body, 0);
        String from = cString(pdu.body, at + 2);
        at = end(pdu.body, at + 2);
        String to = cString(pdu.body, at + 2);
        at = end(pdu.body, at + 2);
        boolean isReceipt = (pdu.body[at] & 0x04) != 0;
        at = end(pdu.body, end(pdu.body, at + 3)) + 4;
        String text = new String(pdu.body, at + 1, pdu.body[at] & 0xff, StandardCharsets.ISO_8859_1);
        deliveries.add(new Delivery(from, to, isReceipt, text));
        write(new Pdu(DELIVER_SM | RESPONSE, 0, pdu.sequence, new byte[1]));
    }

    private static int end(byte[] body, int from) {
        int at = from;
        while (body[at] != 0) {
            at++;
        }
        return at + 1;
    }

    private static String cString(byte[] body, int from) {
        return new String(body, from, end(body, from) - 1 - from, StandardCharsets.ISO_8859_1);
    }

    private void write(Pdu pdu) throws IOException {
        out.writeInt(16 + pdu.body.length);
        out.writeInt(pdu.command);
        out.writeInt(pdu.status);
        out.writeInt(pdu.sequence);
        out.write(pdu.body);
        out.flush();
    }

    private Pdu read() throws IOException {
        int length = in.readInt();
        int command = in.readInt();
        int status = in.readInt();
        int number = in.readInt();
        byte[] body = new byte[length - 16];
        in.readFully(body);
        return new Pdu(command, status, number, body);
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
