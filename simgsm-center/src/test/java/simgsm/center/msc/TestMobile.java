package simgsm.center.msc;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;

/** A mobile that does only what the test tells it, in genuine octets; what the network sends piles up to be looked at. */
final class TestMobile implements LinkPort {
    static final TransactionIdentifier OUR_CALL = new TransactionIdentifier(0, false);

    final TestNetwork network;
    final Imsi imsi;
    final Imei imei;
    final Peer link;

    /** What has come down: layer-3 and RSL messages, CCM messages and speech payloads, oldest first. */
    final ArrayDeque<Object> received = new ArrayDeque<>();

    final List<byte[]> heard = new ArrayList<>();
    final List<byte[]> mgcp = new ArrayList<>();
    Optional<MobileIdentity> temporaryIdentity = Optional.empty();
    /** RAND of the last challenge. */
    Optional<OctetString> challenge = Optional.empty();

    Optional<String> closedFor = Optional.empty();
    boolean answersPings = true;
    /** A message of this kind meets an error of the centre's own while it is sent. */
    Class<?> failsOn = Void.class;

    /** The centre's socket for speech over UDP. */
    private final MediaPort media;

    private int nextSequence;

    TestMobile(TestNetwork network, String number, Imei imei) {
        this(network, number, imei, true);
    }

    TestMobile(TestNetwork network, String number, Imei imei, boolean isLocal) {
        this.network = network;
        this.imsi = Imsi.ofOpenNumber(new Msisdn(number));
        this.imei = imei;
        this.media = network.mediaOf(number);
        this.link = network.exchange.linkOpened(network.nowNanos, this, "peer of " + number, isLocal);
    }

    @Override
    public void send(IpaFrame frame) {
        try {
            switch (frame.stream()) {
                case IpaFrame.CCM -> received.add(CcmCodec.decode(frame.payload()));
                case IpaFrame.SPEECH -> heard.add(frame.payload());
                case IpaFrame.MGCP -> mgcp.add(frame.payload());
                default -> receive(RslMessage.decode(frame.payload()));
            }
        } catch (ProtocolViolation violation) {
            throw new AssertionError("the network sent nonsense", violation);
        }
    }

    private void receive(RslMessage message) throws ProtocolViolation {
        if (message instanceof RslMessage.DataRequest data) {
            Layer3Message layer3 = Layer3Codec.decode(data.layer3().toArray(), Direction.DOWNLINK);
            if (layer3 instanceof MobilityManagement.LocationUpdatingAccept accept) {
                temporaryIdentity = accept.newIdentity();
            }
            if (layer3 instanceof MobilityManagement.AuthenticationRequest request) {
                challenge = Optional.of(request.rand());
            }
            if (failsOn.isInstance(layer3)) {
                throw new IllegalStateException("a made-up error of our own");
            }
            received.add(layer3);
        } else {
            received.add(message);
        }
    }

    @Override
    public Optional<MediaAddress> openMedia() {
        return media.openMedia();
    }

    @Override
    public boolean connectMedia(MediaAddress peer) {
        return media.connectMedia(peer);
    }

    @Override
    public boolean sendMedia(byte[] rtp) {
        return media.sendMedia(rtp);
    }

    @Override
    public void closeMedia() {
        media.closeMedia();
    }

    @Override
    public void close(String reason) {
        closedFor = Optional.of(reason);
    }

    // Up.

    void frame(IpaFrame frame) {
        network.exchange.frameReceived(network.nowNanos, link, frame);
        network.commitIfAtOnce();
    }

    void rsl(RslMessage message) {
        frame(new IpaFrame(IpaFrame.RSL, message.encode()));
    }

    void ccm(CcmMessage message) {
        frame(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    /** Opens a radio connection with this message. */
    void establish(Layer3Message message) {
        nextSequence = 0;
        rsl(new RslMessage.EstablishIndication(RslMessage.Sapi.SIGNALLING, encode(message)));
    }

    void tell(Layer3Message message) {
        rsl(new RslMessage.DataIndication(sapi(message), encode(message)));
    }

    /** The last message again, as a link layer that lost its acknowledgement would. */
    void repeat(Layer3Message message) {
        nextSequence ^= 1;
        tell(message);
    }

    void tellOctets(String hex) {
        rsl(new RslMessage.DataIndication(RslMessage.Sapi.SIGNALLING, OctetString.ofHex(hex)));
    }

    /** A message as its first octet and its type, N(SD) put in, and what follows. */
    void tellNext(String headAndType, String rest) {
        int type = Integer.parseInt(headAndType.substring(2), 16) | nextSequence << 6;
        nextSequence ^= 1;
        tellOctets(headAndType.substring(0, 2) + String.format("%02x", type) + rest);
    }

    void leaveChannel() {
        rsl(new RslMessage.ReleaseIndication(RslMessage.Sapi.SIGNALLING));
    }

    private OctetString encode(Layer3Message message) {
        byte[] octets = Layer3Codec.encode(message, Direction.UPLINK, nextSequence);
        if (Layer3Codec.sendSequence(octets) >= 0) {
            nextSequence ^= 1;
        }
        return OctetString.of(octets);
    }

    private static RslMessage.Sapi sapi(Layer3Message message) {
        return message instanceof ShortMessageControl ? RslMessage.Sapi.SHORT_MESSAGES : RslMessage.Sapi.SIGNALLING;
    }

    void speak(byte[] rtp) {
        frame(new IpaFrame(IpaFrame.SPEECH, rtp));
    }

    void vanish() {
        network.exchange.linkClosed(network.nowNanos, link, "vanished");
    }

    // What has come down.

    /** The next message, which must be of this kind. */
    <T> T next(Class<T> kind) {
        Object message = received.poll();
        if (!kind.isInstance(message)) {
            throw new AssertionError("expected " + kind.getSimpleName() + ", found " + message + " before " + received);
        }
        return kind.cast(message);
    }

    boolean hasNothing() {
        return received.isEmpty();
    }

    /** Answers the pings among what has come, and takes them away; unless the test wants to do that itself. */
    void answerPings() {
        while (answersPings && received.removeFirstOccurrence(new CcmMessage.Ping())) {
            ccm(new CcmMessage.Pong());
        }
    }

    // Whole procedures.

    MobileIdentity identity() {
        return temporaryIdentity.orElse(imsi);
    }

    void requestUpdate(MobileIdentity identity) {
        establish(new MobilityManagement.LocationUpdatingRequest(
                MobilityManagement.LocationUpdatingType.IMSI_ATTACH,
                MobilityManagement.NO_KEY,
                LocationArea.TEST,
                identity));
    }

    /** From the first request to the released channel. */
    TestMobile register() {
        received.clear();
        requestUpdate(imsi);
        network.cards.stream().filter(card -> card.imsi().equals(imsi)).forEach(this::prove);
        next(MobilityManagement.IdentityRequest.class);
        tell(new MobilityManagement.IdentityResponse(imei));
        next(MobilityManagement.LocationUpdatingAccept.class);
        tell(new MobilityManagement.TmsiReallocationComplete());
        next(MobilityManagement.MmInformation.class);
        next(RadioResource.ChannelRelease.class);
        leaveChannel();
        return this;
    }

    /** Takes the challenge that must have come and answers it with this card. */
    MobilityManagement.AuthenticationRequest prove(SimCard card) {
        MobilityManagement.AuthenticationRequest request = next(MobilityManagement.AuthenticationRequest.class);
        tell(responseOf(card));
        return request;
    }

    /** The card's answer to the last challenge. */
    MobilityManagement.AuthenticationResponse responseOf(SimCard card) {
        return new MobilityManagement.AuthenticationResponse(
                card.vector(challenge.orElseThrow()).sres());
    }

    /** Up to CM SERVICE ACCEPT. */
    void requestService(MobilityManagement.ServiceType service) {
        establish(new MobilityManagement.CmServiceRequest(service, MobilityManagement.NO_KEY, identity()));
        next(MobilityManagement.CmServiceAccept.class);
    }

    /** Up to SETUP; the network's answers are the test's to look at. */
    void dial(String number) {
        requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        tell(new CallControl.Setup(OUR_CALL, Optional.empty(), Optional.of(new Msisdn(number))));
    }

    /** Answers the paging that must have come. */
    void answerPaging() {
        next(RslMessage.PagingCommand.class);
        establish(new RadioResource.PagingResponse(MobilityManagement.NO_KEY, identity()));
    }

    /** Answers the paging, and takes the SETUP that follows. */
    CallControl.Setup takeSetup() {
        answerPaging();
        return next(CallControl.Setup.class);
    }

    /** Up to ALERTING. */
    void ring() {
        TransactionIdentifier transaction = takeSetup().transaction().answered();
        tell(new CallControl.CallConfirmed(transaction));
        tell(new CallControl.Alerting(transaction));
    }

    /** The channel has been released; the mobile leaves it. */
    void leaveReleasedChannel() {
        next(RadioResource.ChannelRelease.class);
        leaveChannel();
    }

    void hangUp(TransactionIdentifier transaction) {
        tell(new CallControl.Disconnect(transaction, Cause.NORMAL_CALL_CLEARING));
        next(CallControl.Release.class);
        tell(new CallControl.ReleaseComplete(transaction, Optional.empty()));
    }

    /** DISCONNECT of our call, whatever comes back. */
    void hangUpUnheard() {
        tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING));
    }

    void sendMessage(int transaction, int reference, OctetString tpdu) {
        tell(new ShortMessageControl.CpData(
                new TransactionIdentifier(transaction, false),
                new RelayMessage.RpData(reference, new Msisdn("3003"), tpdu)));
    }

    /** Takes the message that the network is giving, up to the last acknowledgement. */
    OctetString takeMessage() {
        ShortMessageControl.CpData data = next(ShortMessageControl.CpData.class);
        TransactionIdentifier transaction = data.transaction().answered();
        tell(new ShortMessageControl.CpAck(transaction));
        RelayMessage.RpData relay = (RelayMessage.RpData) data.relay();
        tell(new ShortMessageControl.CpData(transaction, new RelayMessage.RpAck(relay.reference(), Optional.empty())));
        next(ShortMessageControl.CpAck.class);
        return relay.tpdu();
    }
}
