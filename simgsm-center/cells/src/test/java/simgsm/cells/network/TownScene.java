package simgsm.cells.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslElement;
import simgsm.abis.RslMessage;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelDescription;
import simgsm.air.ChannelNumber;
import simgsm.air.ChannelNumber.Kind;
import simgsm.air.Direction;
import simgsm.air.Imsi;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.AssignmentCommand;
import simgsm.air.RadioResource.CellDescription;
import simgsm.air.RadioResource.CipheringModeComplete;
import simgsm.air.RadioResource.HandoverCommand;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.mobile.MobilePort;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.SpeechSocket;
import simgsm.cells.tower.TowerPort;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.rr.ImmediateAssignment;
import simgsm.rr.NeighbourList;
import simgsm.rr.RequestReference;
import simgsm.rr.SystemInformation;
import simgsm.rr.SystemInformation.ControlChannel;
import simgsm.rr.SystemInformation.RandomAccess;
import simgsm.rr.SystemInformation.SelectionParameters;

/** A town of two towers 4 km apart; controller and terminal are played by hand, and so is the clock. */
final class TownScene {
    static final long MILLI = 1_000_000L;
    static final ChannelNumber SDCCH = new ChannelNumber(Kind.SDCCH_4, 1, 0);
    static final ChannelNumber TCH = ChannelNumber.of(Kind.TCH_F, 2);
    static final int LINK_TIMEOUT = 16;

    final List<MobileEvent> events = new ArrayList<>();
    final CellNetwork network;
    final Controller west;
    final Controller east;
    long now;

    /** The controller's end of one tower's link. */
    final class Controller implements TowerPort {
        final BaseStation tower;
        final Queue<RslPdu> up = new ArrayDeque<>();
        final List<byte[]> spoken = new ArrayList<>();
        Consumer<byte[]> speech;
        String speechHost = "127.0.0.1";

        Controller(BaseStation tower) {
            this.tower = tower;
        }

        @Override
        public void send(IpaFrame frame) {
            if (frame.stream() == IpaFrame.RSL) {
                try {
                    up.add(RslPdu.decode(frame.payload()));
                } catch (ProtocolViolation e) {
                    throw new AssertionError(e);
                }
            }
        }

        @Override
        public Optional<SpeechSocket> openSpeech(Consumer<byte[]> received) {
            speech = received;
            return Optional.of(new SpeechSocket() {
                @Override
                public MediaAddress address() {
                    return new MediaAddress(speechHost, 4000);
                }

                @Override
                public boolean connect(MediaAddress peer) {
                    return true;
                }

                @Override
                public void send(byte[] rtp) {
                    spoken.add(rtp);
                }

                @Override
                public void close() {
                    speech = null;
                }
            });
        }

        @Override
        public void drop(String reason) {
            tower.disconnected();
        }

        void connect(int area) {
            tower.connected(this);
            SystemInformation.Type3 cell = new SystemInformation.Type3(
                    tower.tower().site(),
                    new LocationArea("001", "01", area),
                    new ControlChannel(true, 1, true, 2, 0),
                    LINK_TIMEOUT,
                    new SelectionParameters(4, 5, 5),
                    new RandomAccess(7, 9, false),
                    Optional.empty());
            down(RslPdu.of(RslType.BCCH_INFORMATION, ChannelNumber.of(Kind.BCCH, 0))
                    .with(RslElement.SYSTEM_INFORMATION_TYPE, 3)
                    .with(RslElement.FULL_BCCH_INFORMATION, cell.encode()));
            down(RslPdu.of(RslType.SACCH_FILLING)
                    .with(RslElement.SYSTEM_INFORMATION_TYPE, 5)
                    .with(
                            RslElement.L3_INFORMATION,
                            new SystemInformation.Neighbours(NeighbourList.TYPE_5, List.of(100, 110)).encode()));
        }

        void down(RslPdu message) {
            tower.frameArrived(new IpaFrame(IpaFrame.RSL, message.encode()));
        }

        void down(ChannelNumber channel, Layer3Message message) {
            down(RslPdu.of(RslType.DATA_REQUEST, channel, 0)
                    .with(
                            RslElement.L3_INFORMATION,
                            OctetString.of(Layer3Codec.encode(message, Direction.DOWNLINK, 0))));
        }

        /** Activates a channel; {@code reference} for a handover. */
        void activate(ChannelNumber channel, int type, Optional<Integer> reference) {
            RslPdu message = RslPdu.of(RslType.CHANNEL_ACTIVATION, channel)
                    .with(RslElement.ACTIVATION_TYPE, type)
                    .with(RslElement.CHANNEL_MODE, 0, channel.kind().isSpeech() ? 1 : 3, 1, 0);
            down(reference.isPresent() ? message.with(RslElement.HANDOVER_REFERENCE, reference.get()) : message);
            expect(RslType.CHANNEL_ACTIVATION_ACKNOWLEDGE);
        }

        void grant(ChannelNumber channel, RequestReference reference) {
            ImmediateAssignment assignment = new ImmediateAssignment(
                    new ChannelDescription(channel, 2, tower.tower().arfcn()), reference, 0);
            down(RslPdu.of(RslType.IMMEDIATE_ASSIGN_COMMAND, ChannelNumber.of(Kind.PCH_AGCH, 0))
                    .with(RslElement.FULL_IMMEDIATE_ASSIGN, assignment.encode()));
        }

        RslPdu expect(RslType type) {
            RslPdu message = up.poll();
            assertNotNull(message, type + " was expected, nothing came");
            assertEquals(type, message.type());
            return message;
        }

        void expectNothing() {
            assertNull(up.peek(), () -> "nothing was expected: " + up);
        }

        /** The hexadecimal octets of layer 3 in the next DATA INDICATION. */
        String expectLayer3() throws ProtocolViolation {
            return expect(RslType.DATA_INDICATION)
                    .value(RslElement.L3_INFORMATION)
                    .toString();
        }

        /** The next CHANNEL REQUIRED, after any time. */
        RequestReference expectAccess() throws ProtocolViolation {
            passUntilSent();
            return RequestReference.of(expect(RslType.CHANNEL_REQUIRED).value(RslElement.REQUEST_REFERENCE));
        }

        void passUntilSent() {
            for (int i = 0; up.isEmpty() && i < 30_000; i++) {
                pass(MILLI);
            }
        }

        void discardReports() {
            up.removeIf(message -> message.type() == RslType.MEASUREMENT_RESULT);
        }
    }

    /** A terminal. */
    final class Terminal implements MobilePort {
        final Queue<RslMessage> down = new ArrayDeque<>();
        final List<Long> heardNanos = new ArrayList<>();
        /** Why the network has closed the connection. */
        final List<String> closed = new ArrayList<>();

        final Imsi imsi;
        final Mobile mobile;

        Terminal(String number) {
            imsi = Imsi.ofOpenNumber(new Msisdn(number));
            mobile = network.connected(this, "terminal");
        }

        @Override
        public void send(IpaFrame frame) {
            if (frame.stream() == IpaFrame.SPEECH) {
                heardNanos.add(now);
                return;
            }
            try {
                RslMessage message = RslMessage.decode(frame.payload());
                boolean isNotice = message instanceof RslMessage.BroadcastInformation
                        || message instanceof RslMessage.MeasurementResult;
                if (!isNotice) {
                    down.add(message);
                }
            } catch (ProtocolViolation e) {
                throw new AssertionError(e);
            }
        }

        @Override
        public void close(String reason) {
            closed.add(reason);
            network.disconnected(mobile);
        }

        void register() {
            send(
                    true,
                    new LocationUpdatingRequest(
                            LocationUpdatingType.IMSI_ATTACH, MobilityManagement.NO_KEY, LocationArea.TEST, imsi));
        }

        void send(boolean isFirst, Layer3Message message) {
            OctetString octets = OctetString.of(Layer3Codec.encode(message, Direction.UPLINK, 0));
            arrived(
                    isFirst
                            ? new RslMessage.EstablishIndication(RslMessage.Sapi.SIGNALLING, octets)
                            : new RslMessage.DataIndication(RslMessage.Sapi.SIGNALLING, octets));
        }

        /** Ciphers with a key of its own. @param information algorithm and key (TS 48.058, 9.3.7) */
        void cipher(String information) {
            arrived(new RslMessage.EncryptionCommand(OctetString.ofHex(information), OctetString.ofHex("063501")));
            send(false, new CipheringModeComplete(Optional.empty()));
        }

        private void arrived(RslMessage message) {
            try {
                mobile.arrived(message);
            } catch (ProtocolViolation e) {
                throw new AssertionError(e);
            }
        }

        void leave() {
            arrived(new RslMessage.ReleaseIndication(RslMessage.Sapi.SIGNALLING));
        }

        String expectLayer3() {
            RslMessage message = down.poll();
            assertNotNull(message, "a message was expected, nothing came");
            return ((RslMessage.DataRequest) message).layer3().toString();
        }

        void expectNothing() {
            assertNull(down.peek(), () -> "nothing was expected: " + down);
        }
    }

    TownScene(int westArea, int eastArea) {
        Town town = new Town(List.of(
                new Tower("west", new TownPlace(0, 0), 30, 43, 100, 10, westArea, 6969),
                new Tower("east", new TownPlace(4_000, 0), 30, 43, 110, 11, eastArea, 6970)));
        network = new CellNetwork(town, 7, events::add);
        west = new Controller(network.towers().get(0));
        east = new Controller(network.towers().get(1));
        west.connect(westArea);
        east.connect(eastArea);
    }

    TownScene() {
        this(1, 1);
    }

    void pass(long nanos) {
        long end = now + nanos;
        for (OptionalLong next = network.nextDeadlineNanos();
                next.isPresent() && next.getAsLong() <= end;
                next = network.nextDeadlineNanos()) {
            now = Math.max(now, next.getAsLong());
            network.advance(now);
        }
        now = end;
        network.advance(now);
    }

    /** A mobile near the west tower, on its SDCCH with its first message sent. */
    Terminal onSignallingChannel() throws ProtocolViolation {
        network.place("5550100", new TownPlace(500, 0));
        Terminal terminal = new Terminal("5550100");
        terminal.register();
        RequestReference reference = west.expectAccess();
        west.activate(SDCCH, 0, Optional.empty());
        west.grant(SDCCH, reference);
        west.expect(RslType.ESTABLISH_INDICATION);
        return terminal;
    }

    /** The same mobile, assigned to a traffic channel with speech. */
    Terminal inCall() throws ProtocolViolation {
        Terminal terminal = onSignallingChannel();
        west.activate(TCH, 1, Optional.empty());
        west.down(SDCCH, new AssignmentCommand(new ChannelDescription(TCH, 2, 100), 5, 1));
        pass(100 * MILLI);
        connectSpeechAfterAssignment();
        return terminal;
    }

    void connectSpeechAfterAssignment() throws ProtocolViolation {
        west.discardReports();
        west.expect(RslType.ESTABLISH_INDICATION);
        assertEquals("062900", west.expectLayer3());
        connectSpeech(west, TCH);
    }

    void connectSpeech(Controller tower, ChannelNumber channel) {
        tower.down(RslPdu.of(RslType.CREATE_CONNECTION, channel)
                .with(RslElement.SPEECH_MODE, 0x10)
                .with(RslElement.RTP_PAYLOAD, 3));
        tower.expect(RslType.CREATE_CONNECTION_ACKNOWLEDGE);
        tower.down(RslPdu.of(RslType.MODIFY_CONNECTION, channel)
                .with(
                        RslElement.REMOTE_IP,
                        new OctetWriter().fourOctets(0x7f000001).toOctetString())
                .with(RslElement.REMOTE_PORT, 0x20, 0x00));
        tower.expect(RslType.MODIFY_CONNECTION_ACKNOWLEDGE);
    }

    /** HANDOVER COMMAND from west to east with this reference. */
    void commandHandover(int reference) {
        west.down(
                TCH,
                new HandoverCommand(
                        new CellDescription(11, 110),
                        new ChannelDescription(TCH, 3, 110),
                        reference,
                        5,
                        Optional.of(1)));
    }
}
