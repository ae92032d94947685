package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.Sapi;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.octets.OctetString;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;

/** The thread against a real socket; what it tells is awaited, never timed. */
@Timeout(30)
class StationThreadTest {
    private static final int PATIENCE_SECONDS = 20;

    private final BlockingQueue<String> told = new ArrayBlockingQueue<>(100);
    private final StationThread thread =
            new StationThread("stations", cause -> told.add("failed " + cause.getMessage()));

    @AfterEach
    void close() {
        thread.close();
    }

    private MobileStation station(String number) {
        Consumer<StationEvent> listener = event -> {
            if (event instanceof StationEvent.StationRegistered registered) {
                told.add("registered " + registered.number());
            } else if (event instanceof StationEvent.StationUnregistered) {
                told.add("unregistered " + number);
            }
        };
        StationIdentity identity =
                StationIdentity.ofOpenNumber(new Msisdn(number), Imei.random(new Random(1)), "SimGSM phone");
        return new MobileStation(
                identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, SpeechSource.SILENCE, listener, new Random(1));
    }

    private void expect(String line) throws InterruptedException {
        assertEquals(line, told.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
    }

    /** A centre's end of one connection. */
    private static final class Center implements AutoCloseable {
        private final Socket socket;
        private final DataInputStream in;
        private final OutputStream out;

        Center(ServerSocket server) throws IOException {
            socket = server.accept();
            in = new DataInputStream(socket.getInputStream());
            out = socket.getOutputStream();
        }

        static ServerSocket listen(int port) throws IOException {
            ServerSocket server = new ServerSocket();
            server.setReuseAddress(true);
            server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
            return server;
        }

        void send(IpaFrame frame) throws IOException {
            out.write(IpaFramer.encode(frame));
        }

        void send(Layer3Message message) throws IOException {
            OctetString octets = OctetString.of(Layer3Codec.encode(message, Direction.DOWNLINK, 0));
            send(new IpaFrame(IpaFrame.RSL, new RslMessage.DataRequest(Sapi.SIGNALLING, octets).encode()));
        }

        /** The next signalling message, frames of other streams passed over; empty for the release of the channel. */
        Optional<Layer3Message> read() throws IOException, ProtocolViolation {
            while (true) {
                byte[] payload = new byte[in.readUnsignedShort()];
                int stream = in.readUnsignedByte();
                in.readFully(payload);
                if (stream == IpaFrame.RSL) {
                    RslMessage message = RslMessage.decode(payload);
                    return message instanceof RslMessage.EstablishIndication first
                            ? Optional.of(Layer3Codec.decode(first.layer3().toArray(), Direction.UPLINK))
                            : Optional.empty();
                }
            }
        }

        void register() throws IOException, ProtocolViolation {
            send(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(new CcmMessage.IdentityRequest())));
            assertTrue(read().orElseThrow() instanceof LocationUpdatingRequest);
            send(new LocationUpdatingAccept(LocationArea.TEST, Optional.empty()));
            send(new ChannelRelease(0));
            assertTrue(read().isEmpty());
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    private static InetSocketAddress address(ServerSocket server) {
        return (InetSocketAddress) server.getLocalSocketAddress();
    }

    @Test
    void aStationRegistersLosesItsCentreAndRegistersAgain() throws Exception {
        try (ServerSocket server = Center.listen(0)) {
            thread.start();
            thread.add(station("5550100"), address(server));
            try (Center center = new Center(server)) {
                center.register();
                expect("registered 5550100");
            }
            expect("unregistered 5550100");
            try (Center center = new Center(server)) {
                center.register();
                expect("registered 5550100");
            }
        }
    }

    @Test
    void withoutACentreItSaysSoAtOnceAndFindsItWhenItComes() throws Exception {
        ServerSocket reserved = Center.listen(0);
        InetSocketAddress address = address(reserved);
        reserved.close();
        thread.add(station("5550100"), address);
        thread.start();
        expect("unregistered 5550100");
        try (ServerSocket server = Center.listen(address.getPort());
                Center center = new Center(server)) {
            center.register();
            expect("registered 5550100");
        }
    }

    @Test
    void oneThreadServesManyStations() throws Exception {
        try (ServerSocket server = Center.listen(0)) {
            thread.start();
            Center[] centers = new Center[20];
            for (int i = 0; i < centers.length; i++) {
                thread.add(station("55501" + (10 + i)), address(server));
            }
            for (int i = 0; i < centers.length; i++) {
                centers[i] = new Center(server);
            }
            for (Center center : centers) {
                center.register();
                assertTrue(told.poll(PATIENCE_SECONDS, TimeUnit.SECONDS).startsWith("registered"));
            }
            for (Center center : centers) {
                center.close();
            }
        }
    }

    @Test
    void closingDetachesFirst() throws Exception {
        try (ServerSocket server = Center.listen(0)) {
            thread.start();
            thread.add(station("5550100"), address(server));
            try (Center center = new Center(server)) {
                center.register();
                expect("registered 5550100");
                Thread closer = new Thread(thread::close);
                closer.start();
                assertTrue(center.read().orElseThrow() instanceof ImsiDetachIndication);
                center.send(new ChannelRelease(0));
                assertTrue(center.read().isEmpty());
                closer.join();
                expect("unregistered 5550100");
            }
        }
    }

    @Test
    void rubbishFromTheCentreDropsTheLinkAndAnotherIsMade() throws Exception {
        try (ServerSocket server = Center.listen(0)) {
            thread.start();
            thread.add(station("5550100"), address(server));
            try (Center center = new Center(server)) {
                center.register();
                expect("registered 5550100");
                center.out.write(new byte[] {(byte) 0xff, (byte) 0xff, 0});
                expect("unregistered 5550100");
                assertEquals(-1, center.in.read());
            }
            try (Center center = new Center(server)) {
                center.register();
                expect("registered 5550100");
            }
        }
    }

    @Test
    void anActThatThrowsDoesNotStopTheThread() throws Exception {
        thread.start();
        thread.execute(() -> {
            throw new IllegalStateException("as a test does");
        });
        thread.execute(() -> told.add("still there"));
        expect("still there");
    }

    @Test
    void anErrorEndsTheThreadAndIsReported() throws Exception {
        thread.start();
        thread.execute(() -> {
            throw new LinkageError("as a test does");
        });
        expect("failed as a test does");
        thread.close();
    }

    /** Each quit would take a second if it waited for what does not come; the class's time-out would end the test. */
    @Test
    void aStationThatIsNotRegisteredQuitsAtOnce() throws Exception {
        for (int i = 0; i < 40; i++) {
            try (ServerSocket server = Center.listen(0);
                    StationThread quick = new StationThread("quick", cause -> told.add("failed"))) {
                quick.add(station("5550100"), address(server));
                quick.start();
                server.accept().close();
                expect("unregistered 5550100");
            }
        }
        assertTrue(told.stream().noneMatch("failed"::equals));
    }

    @Test
    void closingAThreadThatNeverStartedReturns() {
        thread.close();
        assertThrows(IllegalStateException.class, () -> thread.ask(() -> "an answer"));
    }

    @Test
    void aCentreThatCannotBeResolvedIsNoCentre() throws Exception {
        thread.start();
        thread.add(station("5550100"), InetSocketAddress.createUnresolved("no.such.host.invalid", 3003));
        expect("unregistered 5550100");
    }
}
