package simgsm.center.smpp;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.smpp.Tlv;

/** An application on a real socket, one PDU after the other; also sends what no application should. */
public final class SmppClient implements AutoCloseable {
    /** Longer than any answer takes; a test that waits this time has failed. */
    private static final int PATIENCE_MILLIS = 20_000;

    private final Socket socket;
    private final DataInputStream in;
    private int sequence;

    public SmppClient(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(PATIENCE_MILLIS);
        socket.setTcpNoDelay(true);
        in = new DataInputStream(socket.getInputStream());
    }

    static SmppMessage text(String from, String to, String text) {
        return message(from, to, 0, 0, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    static SmppMessage message(String from, String to, int esmClass, int dataCoding, byte[] octets) {
        return SmppMessage.of(
                new SmppAddress(1, 1, from),
                new SmppAddress(1, 1, to),
                esmClass,
                0,
                dataCoding,
                OctetString.of(octets),
                List.of());
    }

    static SmppMessage withReceipt(SmppMessage m) {
        return with(m, m.validity(), 1, m.parameters());
    }

    static SmppMessage with(SmppMessage m, String validity, int registeredDelivery, List<Tlv> parameters) {
        return new SmppMessage(
                m.serviceType(),
                m.source(),
                m.destination(),
                m.esmClass(),
                m.protocolId(),
                m.priority(),
                m.schedule(),
                validity,
                registeredDelivery,
                m.replaceIfPresent(),
                m.dataCoding(),
                m.defaultMessageId(),
                m.shortMessage(),
                parameters);
    }

    public void write(byte[] octets) throws IOException {
        socket.getOutputStream().write(octets);
    }

    public void send(SmppPdu pdu) throws IOException {
        write(SmppCodec.encode(pdu));
    }

    /** The next PDU. EOFException when the centre has closed the connection. */
    public SmppPdu read() throws IOException {
        int length;
        try {
            length = in.readInt();
        } catch (SocketException e) {
            throw new EOFException();
        }
        byte[] octets = new byte[length];
        for (int i = 0; i < 4; i++) {
            octets[i] = (byte) (length >> 8 * (3 - i));
        }
        in.readFully(octets, 4, length - 4);
        try {
            return SmppCodec.decode(octets);
        } catch (SmppViolation violation) {
            throw new AssertionError(violation);
        }
    }

    /** The next PDU of this kind; others are passed over. */
    public <T extends SmppPdu> T read(Class<T> kind) throws IOException {
        while (true) {
            SmppPdu pdu = read();
            if (kind.isInstance(pdu)) {
                return kind.cast(pdu);
            }
        }
    }

    /** Binds and returns the status. */
    public int bind(SmppCommand command, String systemId, String password, String range) throws IOException {
        send(new SmppPdu.Bind(command, ++sequence, systemId, password, "", 0x34, range));
        return read(SmppPdu.BindResponse.class).status();
    }

    public static SmppClient bound(int port, SmppCommand command, String systemId, String range) throws IOException {
        SmppClient client = new SmppClient(port);
        int status = client.bind(command, systemId, "", range);
        if (status != SmppStatus.OK) {
            throw new AssertionError("bind answered with status " + status);
        }
        return client;
    }

    /** Hands a message in and returns the answer. */
    SmppPdu.MessageResponse submit(SmppMessage message) throws IOException {
        send(new SmppPdu.Message(SmppCommand.SUBMIT_SM, ++sequence, message));
        return read(SmppPdu.MessageResponse.class);
    }

    /** The same, where it must be taken; returns the message id. */
    String submitted(SmppMessage message) throws IOException {
        SmppPdu.MessageResponse response = submit(message);
        if (response.status() != SmppStatus.OK) {
            throw new AssertionError("refused with status " + response.status());
        }
        return response.messageId();
    }

    /** The next delivery, answered with this status. */
    SmppMessage take(int status) throws IOException {
        SmppPdu.Message delivery = read(SmppPdu.Message.class);
        send(new SmppPdu.MessageResponse(SmppCommand.DELIVER_SM, status, delivery.sequence(), ""));
        return delivery.message();
    }

    SmppMessage take() throws IOException {
        return take(SmppStatus.OK);
    }

    int nextSequence() {
        return ++sequence;
    }

    /** Reads until the centre has closed the connection. */
    void awaitEnd() throws IOException {
        try {
            while (true) {
                read();
            }
        } catch (EOFException e) {
            return;
        }
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
