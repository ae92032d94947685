package simgsm.center.net;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.Optional;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/** A terminal on a real socket, whose octets go out as the test wants them. */
final class TestClient implements AutoCloseable {
    /** Longer than any answer takes; a test that waits this time has failed. */
    private static final int PATIENCE_MILLIS = 20_000;

    private final Socket socket;
    private final IpaFramer framer = new IpaFramer();

    TestClient(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(PATIENCE_MILLIS);
        socket.setTcpNoDelay(true);
    }

    void write(byte[] octets) throws IOException {
        socket.getOutputStream().write(octets);
        socket.getOutputStream().flush();
    }

    void writeByteByByte(byte[] octets) throws IOException {
        for (byte octet : octets) {
            write(new byte[] {octet});
        }
    }

    /** The next frame from the centre. EOFException when it has closed the connection. */
    IpaFrame read() throws IOException {
        byte[] buffer = new byte[4096];
        while (true) {
            try {
                Optional<IpaFrame> frame = framer.next();
                if (frame.isPresent()) {
                    return frame.get();
                }
            } catch (ProtocolViolation violation) {
                throw new AssertionError(violation);
            }
            int count = socket.getInputStream().read(buffer);
            if (count < 0) {
                throw new EOFException();
            }
            framer.accept(ByteBuffer.wrap(buffer, 0, count));
        }
    }

    /** The next layer-3 message of this kind; everything before it is passed over. */
    <T> T await(Class<T> kind) throws IOException, ProtocolViolation {
        while (true) {
            IpaFrame frame = read();
            if (frame.stream() == IpaFrame.RSL
                    && RslMessage.decode(frame.payload()) instanceof RslMessage.DataRequest data) {
                Layer3Message message = Layer3Codec.decode(data.layer3().toArray(), Direction.DOWNLINK);
                if (kind.isInstance(message)) {
                    return kind.cast(message);
                }
            }
        }
    }

    /** Reads until the centre has closed the connection. */
    void awaitEnd() throws IOException {
        try {
            while (true) {
                read();
            }
        } catch (EOFException e) {
            return;
        } catch (java.net.SocketException e) {
            return; // Reset: closed while octets of ours were still unread.
        }
    }

    static byte[] establish(Layer3Message message) {
        return frame(new RslMessage.EstablishIndication(RslMessage.Sapi.SIGNALLING, layer3(message, 0)));
    }

    static byte[] tell(Layer3Message message, int sequence) {
        return frame(new RslMessage.DataIndication(RslMessage.Sapi.SIGNALLING, layer3(message, sequence)));
    }

    static byte[] frame(RslMessage message) {
        return IpaFramer.encode(new IpaFrame(IpaFrame.RSL, message.encode()));
    }

    static byte[] frame(CcmMessage message) {
        return IpaFramer.encode(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    private static OctetString layer3(Layer3Message message, int sequence) {
        return OctetString.of(Layer3Codec.encode(message, Direction.UPLINK, sequence));
    }

    static byte[] updateRequest(String number) {
        return establish(new MobilityManagement.LocationUpdatingRequest(
                MobilityManagement.LocationUpdatingType.IMSI_ATTACH,
                MobilityManagement.NO_KEY,
                LocationArea.TEST,
                Imsi.ofOpenNumber(new Msisdn(number))));
    }

    /** Refused, since no terminal has registered. */
    static IpaFrame serviceRequest() {
        MobilityManagement.CmServiceRequest request = new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SHORT_MESSAGE,
                MobilityManagement.NO_KEY,
                Imsi.ofOpenNumber(new Msisdn("5550100")));
        return new IpaFrame(
                IpaFrame.RSL,
                new RslMessage.EstablishIndication(RslMessage.Sapi.SIGNALLING, layer3(request, 0)).encode());
    }

    static byte[] identity() {
        return tell(new MobilityManagement.IdentityResponse(new Imei("001017500000010")), 1);
    }

    /** From the first request to LOCATION UPDATING ACCEPT. */
    void register(String number) throws IOException, ProtocolViolation {
        write(updateRequest(number));
        await(MobilityManagement.IdentityRequest.class);
        write(identity());
        await(MobilityManagement.LocationUpdatingAccept.class);
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
