package simgsm.center.msc.link;

import java.util.Locale;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText;

/** A terminal that is mobile and cell in one: each radio connection uses the same channel of its link. */
public final class TerminalAccess implements RadioAccess, BroadcastChannel, PeerUser {
    private final Peer peer;
    private final Link link;
    private final LinkMedia media;
    private final MobileUplink uplink;

    /** @param speaksUdp true to ask the terminal for speech as RTP over UDP */
    public TerminalAccess(Peer peer, Link.Context context, MobileUplink uplink, boolean speaksUdp) {
        this.peer = peer;
        this.uplink = uplink;
        this.link = new Link(this, peer.address(), peer.isLocal(), context);
        this.media = new LinkMedia(link, peer.port(), speaksUdp);
    }

    /** The terminal of this peer, if it is one. */
    public static Link linkOf(Peer peer) {
        return ((TerminalAccess) peer.user()).link;
    }

    // Up.

    @Override
    public void received(IpaFrame frame) throws ProtocolViolation {
        switch (frame.stream()) {
            case IpaFrame.SPEECH -> uplink.spoke(link, frame);
            case IpaFrame.RSL -> receive(RslMessage.decode(frame.payload()));
            case IpaFrame.MGCP -> media.receive(frame.payload());
            default -> link.violated("sent a frame of unknown stream " + frame.stream());
        }
    }

    private void receive(RslMessage message) {
        link.touch();
        if (message instanceof RslMessage.EstablishIndication establish) {
            uplink.established(link, establish.sapi(), establish.layer3());
        } else if (message instanceof RslMessage.DataIndication data) {
            uplink.received(link, data.layer3());
        } else if (message instanceof RslMessage.ReleaseIndication release) {
            if (release.sapi() == RslMessage.Sapi.SIGNALLING) {
                uplink.left(link);
            }
        } else if (message instanceof RslMessage.ErrorIndication error) {
            link.violated("reports link layer error " + error.cause());
        } else {
            link.violated("sent " + message.getClass().getSimpleName() + ", which only the network sends");
        }
    }

    @Override
    public void violated(String what) {
        link.violated(what);
    }

    @Override
    public void failed(RuntimeException e) {
        link.failed(e);
    }

    @Override
    public boolean isKnown() {
        return link.hasNumber();
    }

    @Override
    public void closed() {
        media.close();
        link.forget();
    }

    // Down.

    @Override
    public void send(RslMessage.Sapi sapi, OctetString layer3) {
        send(new RslMessage.DataRequest(sapi, layer3));
    }

    private void send(RslMessage message) {
        peer.port().send(new IpaFrame(IpaFrame.RSL, message.encode()));
    }

    @Override
    public void release() {
        link.send(new RadioResource.ChannelRelease(RadioResource.NORMAL_EVENT));
    }

    @Override
    public void page(MobileIdentity identity) {
        sendCommon(new RslMessage.PagingCommand(identity));
    }

    @Override
    public BroadcastChannel broadcastChannel() {
        return this;
    }

    @Override
    public void broadcast(OctetString page) {
        sendCommon(new RslMessage.SmsBroadcastCommand(page));
    }

    private void sendCommon(RslMessage message) {
        OctetString octets = OctetString.of(message.encode());
        link.trace(Direction.DOWNLINK, MessageText.ofRsl(octets, Locale.ROOT).name(), octets);
        send(message);
    }

    @Override
    public LocationArea area() {
        return LocationArea.TEST;
    }

    @Override
    public void setSpeechNeed(SpeechNeed need) {
        media.setInUse(need == SpeechNeed.HEARD);
    }

    @Override
    public void sendSpeech(IpaFrame frame) {
        media.sendSpeech(frame);
    }

    @Override
    public boolean isShared() {
        return false;
    }

    @Override
    public void close(String reason) {
        peer.drop(reason);
    }

    @Override
    public String toString() {
        return link.toString();
    }
}
