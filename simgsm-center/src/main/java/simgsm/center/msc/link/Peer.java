package simgsm.center.msc.link;

import java.lang.System.Logger.Level;
import java.util.function.BiFunction;
import java.util.function.Function;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.KeepAlive;
import simgsm.air.ProtocolViolation;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * One connection to the centre's port, a terminal's until its identity declares a tower. An opaque handle to the
 * exchange's driver.
 */
public final class Peer {
    private static final System.Logger LOG = System.getLogger(Peer.class.getName());

    private final LinkPort port;
    private final String address;
    private final boolean isLocal;
    private final Timers timers;
    private final KeepAlive keepAlive;
    private final BiFunction<Peer, CcmMessage.IdentityResponse, PeerUser> towers;
    private PeerUser user;
    private Timer identification;
    private boolean isClosed;

    /**
     * @param isLocal true if the peer runs on this machine, without rate limits
     * @param terminal creates the initial user
     * @param towers creates the user of a peer that declares a tower
     */
    public Peer(
            LinkPort port,
            String address,
            boolean isLocal,
            Timers timers,
            Function<Peer, PeerUser> terminal,
            BiFunction<Peer, CcmMessage.IdentityResponse, PeerUser> towers) {
        this.port = port;
        this.address = address;
        this.isLocal = isLocal;
        this.timers = timers.ownedBy(e -> user.failed(e));
        this.towers = towers;
        this.keepAlive = new KeepAlive(this.timers, this::send, this::drop);
        this.user = terminal.apply(this);
    }

    /** Requests the peer's identity and begins to supervise the connection. */
    public void open() {
        send(new CcmMessage.IdentityRequest());
        keepAlive.start();
        identification = timers.start(NetworkTimer.IDENTIFICATION.nanos(), this::checkIdentity);
    }

    private void checkIdentity() {
        if (!user.isKnown()) {
            drop("has not identified itself");
        }
    }

    /** Handles a frame of any stream. */
    public void received(IpaFrame frame) throws ProtocolViolation {
        if (frame.stream() == IpaFrame.CCM) {
            receive(CcmCodec.decode(frame.payload()));
        } else {
            user.received(frame);
        }
    }

    private void receive(CcmMessage message) {
        if (message instanceof CcmMessage.IdentityResponse identity) {
            timers.cancel(identification);
            send(new CcmMessage.IdentityAcknowledge());
            if (identity.isTower()) {
                becomeTower(identity);
            }
        } else {
            keepAlive.receive(message);
        }
    }

    private void becomeTower(CcmMessage.IdentityResponse identity) {
        if (user.isKnown()) {
            violated("says that it is tower " + identity.unitId() + " after it has been used");
        } else {
            PeerUser terminal = user;
            try {
                user = towers.apply(this, identity);
                terminal.closed();
            } catch (IllegalArgumentException e) {
                // the reason, as the unit name of an identity
                send(new CcmMessage.IdentityResponse(e.getMessage(), ""));
                drop("is no tower: " + e.getMessage());
            }
        }
    }

    private void send(CcmMessage message) {
        port.send(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    public LinkPort port() {
        return port;
    }

    public String address() {
        return address;
    }

    /** The address without the port. */
    public String host() {
        int port = address.lastIndexOf(':');
        return port < 0 ? address : address.substring(0, port);
    }

    /** True after 30 to 60 s without a frame of the peer, which may be lost. */
    public boolean isSilent() {
        return keepAlive.isSilent();
    }

    public boolean isLocal() {
        return isLocal;
    }

    public boolean isClosed() {
        return isClosed;
    }

    PeerUser user() {
        return user;
    }

    /** Counts and logs a protocol error of the peer. */
    public void violated(String what) {
        user.violated(what);
    }

    /** Closes the connection. */
    public void drop(String reason) {
        if (!isClosed) {
            LOG.log(user.isKnown() ? Level.INFO : Level.DEBUG, "{0}: closed, {1}", this, reason);
            end();
            port.close(reason);
        }
    }

    /** The connection was closed by the peer, or is broken. */
    public void lost(String reason) {
        if (!isClosed) {
            LOG.log(user.isKnown() ? Level.INFO : Level.DEBUG, "{0}: gone, {1}", this, reason);
            end();
        }
    }

    private void end() {
        isClosed = true;
        keepAlive.stop();
        timers.cancel(identification);
        user.closed();
    }

    @Override
    public String toString() {
        return user.toString();
    }
}
