package simgsm.cells.net;

import java.lang.System.Logger.Level;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaConnection;
import simgsm.abis.IpaFrame;
import simgsm.abis.KeepAlive;
import simgsm.abis.RslMessage;
import simgsm.air.ProtocolViolation;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobilePort;
import simgsm.net.LineAddress;
import simgsm.timer.RateLimit;

/** The connection of one terminal, for which the program acts like a centre. */
final class MobileConnection extends IpaConnection implements MobilePort {
    private static final System.Logger LOG = System.getLogger(MobileConnection.class.getName());
    private static final int FRAMES_PER_SECOND = 20_000;
    private static final int MOST_FRAMES = 2_000;
    /** Number of a terminal's protocol errors after which its connection is closed. */
    private static final int MOST_VIOLATIONS = 100;

    private final CellsLoop cells;
    /** Null until the terminal has said what it is, or something else. */
    private Mobile mobile;

    private KeepAlive keepAlive;
    private int violations;

    MobileConnection(Endpoint endpoint, CellsLoop cells) {
        super(endpoint, new RateLimit(FRAMES_PER_SECOND, FRAMES_PER_SECOND), MOST_FRAMES, written -> {});
        this.cells = cells;
    }

    @Override
    protected void opened() {
        keepAlive = new KeepAlive(cells.now().timers(), this::send, this::fail);
        keepAlive.start();
        send(new CcmMessage.IdentityRequest());
    }

    private void send(CcmMessage message) {
        send(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    @Override
    protected void frameArrived(IpaFrame frame) {
        cells.now();
        keepAlive.heard();
        try {
            switch (frame.stream()) {
                case IpaFrame.RSL -> mobile("").arrived(RslMessage.decode(frame.payload()));
                case IpaFrame.SPEECH -> mobile("").speechArrived(frame.payload());
                case IpaFrame.CCM -> arrived(CcmCodec.decode(frame.payload()));
                default -> LOG.log(Level.DEBUG, "{0}: a frame of stream {1} dropped", mobile, frame.stream());
            }
        } catch (ProtocolViolation e) {
            LOG.log(Level.WARNING, "{0}: {1}", mobile, e.getMessage());
            violations++;
            if (violations == MOST_VIOLATIONS) {
                fail(MOST_VIOLATIONS + " protocol errors");
            }
        }
    }

    private void arrived(CcmMessage message) {
        if (message instanceof CcmMessage.IdentityResponse identity) {
            mobile(identity.serialNumber());
            send(new CcmMessage.IdentityAcknowledge());
        } else {
            keepAlive.receive(message);
        }
    }

    /** The terminal's mobile. @param imei names it until its number is known; without a valid one, its address does */
    private Mobile mobile(String imei) {
        if (mobile == null) {
            String name = imei.matches("[0-9]{14,16}")
                    ? "IMEI-" + imei
                    : LineAddress.of(address()).toString();
            mobile = cells.now().connected(this, name);
        }
        return mobile;
    }

    @Override
    protected void closing(boolean isByPeer) {
        super.closing(isByPeer);
        if (keepAlive != null) {
            keepAlive.stop();
        }
        if (mobile != null) {
            cells.now().disconnected(mobile);
        }
    }

    @Override
    public void close(String reason) {
        fail(reason);
    }
}
