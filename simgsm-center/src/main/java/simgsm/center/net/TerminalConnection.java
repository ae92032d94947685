package simgsm.center.net;

import java.util.function.Consumer;
import simgsm.abis.IpaConnection;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;
import simgsm.center.capture.WireTap;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.timer.RateLimit;

/** The connection of one terminal or tower to the exchange. */
final class TerminalConnection extends IpaConnection implements LinkPort {
    /** Limit of a remote peer: twenty times a call with all its keys. */
    static final int REMOTE_FRAMES_PER_SECOND = 1_000;
    /** Above the speech that any peer holds back. */
    static final int REMOTE_BURST_FRAMES = 2_000;
    /** Limit of a local peer: a phone that receives thousands of short messages a second. */
    static final int LOCAL_FRAMES_PER_SECOND = 20_000;

    static final int LOCAL_BURST_FRAMES = 20_000;

    private static final int MOST_SIGNALLING_FRAMES = 2_000;

    private final CenterLoop center;
    private final WireTap tap;
    private Peer peer;

    TerminalConnection(Endpoint endpoint, CenterLoop center, WireTap tap) {
        super(endpoint, rate(endpoint.address().getAddress().isLoopbackAddress()), MOST_SIGNALLING_FRAMES, tap::sent);
        this.center = center;
        this.tap = tap;
    }

    static RateLimit rate(boolean isLocal) {
        return isLocal
                ? new RateLimit(LOCAL_FRAMES_PER_SECOND, LOCAL_BURST_FRAMES)
                : new RateLimit(REMOTE_FRAMES_PER_SECOND, REMOTE_BURST_FRAMES);
    }

    @Override
    protected void opened() {
        peer = center.changing().linkOpened(center.nowNanos(), this, CenterLoop.text(address()), isLocal());
    }

    @Override
    protected void frameArrived(IpaFrame frame) {
        tap.received(frame);
        speechArrived(frame);
    }

    @Override
    protected void speechArrived(IpaFrame frame) {
        center.changing().frameReceived(center.nowNanos(), peer, frame);
    }

    @Override
    public MediaPort newMedia(Consumer<byte[]> received) {
        return furtherMedia(rtp -> center.changing().perform(center.nowNanos(), () -> received.accept(rtp)));
    }

    @Override
    protected void mediaPassed(boolean isFromPeer, int peerPort, int ownPort, byte[] rtp) {
        tap.datagram(isFromPeer, peerPort, ownPort, rtp);
    }

    @Override
    protected void closing(boolean isByPeer) {
        super.closing(isByPeer);
        tap.closed(isByPeer);
    }

    @Override
    protected void lost(String reason) {
        center.changing().linkClosed(center.nowNanos(), peer, reason);
    }

    @Override
    public void close(String reason) {
        close();
    }
}
