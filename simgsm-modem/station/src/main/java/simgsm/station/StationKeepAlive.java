package simgsm.station;

import java.lang.System.Logger.Level;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.air.ProtocolViolation;

/** Connection control: says who we are, answers pings, and drops a peer that answers none of ours. */
final class StationKeepAlive {
    private static final int MOST_UNANSWERED = 3;

    private final StationParts parts;
    private final Runnable identified;
    private Uplink uplink = Uplink.DISCONNECTED;
    private int unanswered;

    /** @param identified done once the centre knows who we are */
    StationKeepAlive(StationParts parts, Runnable identified) {
        this.parts = parts;
        this.identified = identified;
    }

    void linkUp(Uplink newUplink) {
        uplink = newUplink;
        unanswered = 0;
        parts.timers().start(StationTimer.PING);
        parts.timers().start(StationTimer.IDENTITY);
    }

    void linkDown() {
        uplink = Uplink.DISCONNECTED;
        parts.timers().stop(StationTimer.PING);
        parts.timers().stop(StationTimer.IDENTITY);
    }

    /** The peer has shown that it lives. */
    void heard() {
        unanswered = 0;
    }

    void pingDue() {
        if (unanswered == MOST_UNANSWERED) {
            parts.log().trace(Level.WARNING, "the centre is silent: link dropped");
            uplink.drop();
            return;
        }
        unanswered++;
        send(new CcmMessage.Ping());
        parts.timers().start(StationTimer.PING);
    }

    /** The centre does not ask: then it need not know. */
    void identityExpired() {
        identified.run();
    }

    void arrived(byte[] payload) {
        try {
            arrived(CcmCodec.decode(payload));
        } catch (ProtocolViolation e) {
            parts.log().trace(Level.WARNING, "CCM frame dropped: {0}", e.getMessage());
        }
    }

    private void arrived(CcmMessage message) {
        if (message instanceof CcmMessage.Ping) {
            send(new CcmMessage.Pong());
        } else if (message instanceof CcmMessage.IdentityRequest) {
            send(new CcmMessage.IdentityResponse(
                    parts.identity().unitName(), parts.identity().imei().digits()));
            send(new CcmMessage.IdentityAcknowledge());
            parts.timers().stop(StationTimer.IDENTITY);
            identified.run();
        }
    }

    private void send(CcmMessage message) {
        uplink.send(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }
}
