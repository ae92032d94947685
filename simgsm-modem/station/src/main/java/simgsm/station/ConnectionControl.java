package simgsm.station;

import java.lang.System.Logger.Level;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.KeepAlive;
import simgsm.air.ProtocolViolation;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationTimer;

/** Connection control (CCM): identifies the station to the centre and supervises the connection. */
final class ConnectionControl {
    private final StationContext context;
    private final Runnable identified;
    private final KeepAlive keepAlive;

    /** @param identified runs once the centre has asked for the identity, or has not asked within 2 s */
    ConnectionControl(StationContext context, Runnable identified) {
        this.context = context;
        this.identified = identified;
        keepAlive = new KeepAlive(context.timers().unnamed(), this::send, this::drop);
    }

    void linkUp() {
        keepAlive.start();
        context.timers().start(StationTimer.IDENTITY, identified);
    }

    void linkDown() {
        keepAlive.stop();
        context.timers().stop(StationTimer.IDENTITY);
    }

    /** Every frame shows that the centre is alive. */
    void heard() {
        keepAlive.heard();
    }

    void arrived(byte[] payload) {
        try {
            CcmMessage message = CcmCodec.decode(payload);
            keepAlive.receive(message);
            if (message instanceof CcmMessage.IdentityRequest) {
                send(new CcmMessage.IdentityResponse(
                        context.identity().unitName(), context.identity().imei().digits()));
                send(new CcmMessage.IdentityAcknowledge());
                context.timers().stop(StationTimer.IDENTITY);
                identified.run();
            }
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "CCM frame dropped: {0}", e.getMessage());
        }
    }

    private void send(CcmMessage message) {
        context.radio().send(IpaFrame.CCM, CcmCodec.encode(message));
    }

    private void drop(String reason) {
        context.log().trace(Level.WARNING, "link dropped: {0}", reason);
        context.radio().dropLink();
    }
}
