package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Random;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.Sapi;
import simgsm.abis.RtpPacket;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.ShortMessageControl;
import simgsm.air.Tmsi;
import simgsm.octets.OctetString;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/** A station on the stage: the network is played by hand, and so is the clock. */
final class Scene implements Uplink {
    static final Msisdn OWN = new Msisdn("5550100");
    static final Msisdn OTHER = new Msisdn("5550200");
    static final Tmsi TMSI = new Tmsi(0x1234abcd);
    static final long MILLI = 1_000_000L;
    static final long SECOND = 1_000 * MILLI;

    final StationIdentity identity = StationIdentity.ofOpenNumber(OWN, new Imei("490154203237518"), "SimGSM phone");
    final ReportedEvents reported = new ReportedEvents();
    final short[] speech = new short[160];
    /** Frames that the source drops before the next one. */
    int framesDropped;

    private final SpeechSource source = new SpeechSource() {
        @Override
        public void read(short[] frame) {
            System.arraycopy(speech, 0, frame, 0, speech.length);
        }

        @Override
        public int framesDropped() {
            int frames = framesDropped;
            framesDropped = 0;
            return frames;
        }
    };
    final Queue<RslMessage> up = new ArrayDeque<>();
    final Queue<CcmMessage> ccm = new ArrayDeque<>();
    final List<RtpPacket> spoken = new ArrayList<>();
    final List<byte[]> mgcp = new ArrayList<>();
    /** Where the station's shell could receive media. */
    Optional<MediaAddress> ownMedia = Optional.empty();

    Optional<MediaAddress> mediaPeer = Optional.empty();
    final MobileStation station;
    /** N(SD) of the last message that carried one. */
    int lastSendSequence = -1;

    boolean dropped;
    long now = 1_000 * SECOND;

    Scene() {
        this(Sim.WITHOUT_KEY);
    }

    Scene(Sim sim) {
        this(sim, StationOptions.STANDARD);
    }

    Scene(Sim sim, StationOptions options) {
        station = new MobileStation(identity, sim, options, source, reported, new Random(1));
        reported.station = station;
        station.timePassed(now);
    }

    /** A station that is registered, its radio connection released, nothing left to read. */
    static Scene registered() {
        return registered(StationOptions.STANDARD);
    }

    static Scene registered(StationOptions options) {
        Scene scene = new Scene(Sim.WITHOUT_KEY, options);
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.releaseChannel();
        scene.reported.clear();
        scene.ccm.clear();
        return scene;
    }

    void linkUp() {
        station.linkUp(this, now);
    }

    void linkDown() {
        station.linkDown(now);
    }

    void identify() {
        ccm(new CcmMessage.IdentityRequest());
    }

    void acceptLocationUpdating() {
        expect(LocationUpdatingRequest.class);
        grantLocationUpdating();
    }

    void grantLocationUpdating() {
        down(new LocationUpdatingAccept(LocationArea.TEST, Optional.of(TMSI)));
        expect(TmsiReallocationComplete.class);
    }

    void acceptService() {
        expect(CmServiceRequest.class);
        down(new CmServiceAccept());
    }

    void releaseChannel() {
        down(new ChannelRelease(0));
        expectReleaseIndication();
    }

    void down(Layer3Message message) {
        down(Layer3Codec.encode(message, Direction.DOWNLINK, 0), message instanceof ShortMessageControl);
    }

    /** Octets of layer 3, sound or not. */
    void downHex(String hex) {
        down(OctetString.ofHex(hex).toArray(), hex.charAt(1) == '9');
    }

    private void down(byte[] layer3, boolean shortMessage) {
        Sapi sapi = shortMessage ? Sapi.SHORT_MESSAGES : Sapi.SIGNALLING;
        rsl(new RslMessage.DataRequest(sapi, OctetString.of(layer3)));
    }

    void page(MobileIdentity mobile) {
        rsl(new RslMessage.PagingCommand(mobile));
    }

    void rsl(RslMessage message) {
        frame(IpaFrame.RSL, message.encode());
    }

    void ccm(CcmMessage message) {
        frame(IpaFrame.CCM, CcmCodec.encode(message));
    }

    void frame(int stream, byte[] payload) {
        station.frameArrived(new IpaFrame(stream, payload), now);
    }

    /** Moves the clock, deadline by deadline. */
    void pass(long nanos) {
        long end = now + nanos;
        for (long next = station.nextDeadlineNanos(); next <= end; next = station.nextDeadlineNanos()) {
            now = Math.max(now, next);
            station.timePassed(now);
        }
        now = end;
        station.timePassed(now);
    }

    /** The next message that the station has sent, which must be the first of a radio connection. */
    <M extends Layer3Message> M expectFirst(Class<M> type) {
        if (!(up.poll() instanceof RslMessage.EstablishIndication first)) {
            return fail("no radio connection was opened");
        }
        return type.cast(decode(first.layer3()));
    }

    /** The next message that the station has sent. */
    <M extends Layer3Message> M expect(Class<M> type) {
        RslMessage next = up.poll();
        if (next instanceof RslMessage.EstablishIndication first) {
            return checked(type, decode(first.layer3()));
        }
        if (next instanceof RslMessage.DataIndication data) {
            return checked(type, decode(data.layer3()));
        }
        return fail("expected " + type.getSimpleName() + ", the station sent " + next);
    }

    void expect(Layer3Message message) {
        assertEquals(message, expect(message.getClass()));
    }

    void expectReleaseIndication() {
        assertEquals(new RslMessage.ReleaseIndication(Sapi.SIGNALLING), up.poll());
    }

    void expectNothing() {
        assertEquals(List.of(), List.copyOf(up), "nothing more was to be sent");
    }

    private static <M extends Layer3Message> M checked(Class<M> type, Layer3Message message) {
        if (!type.isInstance(message)) {
            fail("expected " + type.getSimpleName() + ", the station sent " + message);
        }
        return type.cast(message);
    }

    private Layer3Message decode(OctetString octets) {
        try {
            int sequence = Layer3Codec.sendSequence(octets.toArray());
            lastSendSequence = sequence < 0 ? lastSendSequence : sequence;
            return Layer3Codec.decode(octets.toArray(), Direction.UPLINK);
        } catch (ProtocolViolation e) {
            return fail(e);
        }
    }

    @Override
    public void send(IpaFrame frame) {
        try {
            switch (frame.stream()) {
                case IpaFrame.RSL -> up.add(RslMessage.decode(frame.payload()));
                case IpaFrame.CCM -> ccm.add(CcmCodec.decode(frame.payload()));
                case IpaFrame.MGCP -> mgcp.add(frame.payload());
                case IpaFrame.SPEECH -> spoken.add(RtpPacket.decode(frame.payload()));
                default -> fail("frame of stream " + frame.stream());
            }
        } catch (ProtocolViolation e) {
            fail(e);
        }
    }

    @Override
    public Optional<MediaAddress> openMedia() {
        return ownMedia;
    }

    @Override
    public boolean connectMedia(MediaAddress peer) {
        mediaPeer = Optional.of(peer);
        return true;
    }

    @Override
    public void closeMedia() {
        mediaPeer = Optional.empty();
    }

    @Override
    public void drop() {
        dropped = true;
    }
}
