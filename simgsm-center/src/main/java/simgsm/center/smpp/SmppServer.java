package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.Optional;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.timer.Timers;

/** The centre's side of SMPP for all applications. A deterministic core on the exchange's thread and timers. */
public final class SmppServer {
    static final String SYSTEM_ID = "SimGSM";
    static final int INTERFACE_VERSION = 0x34;

    private static final System.Logger LOG = System.getLogger(SmppServer.class.getName());

    private final Timers timers;
    private final EsmeRoutes routes = new EsmeRoutes();
    private final MessageStatusStore statuses = new MessageStatusStore();
    private SmppUsers users = SmppUsers.anyLocal();
    private ShortMessageCenter center;
    private SubmitHandler submissions;
    private int sessions;

    public SmppServer(Timers timers) {
        this.timers = timers;
    }

    /** Connects server and short message centre; the centre's delivery port needs {@link #routes} before. */
    public void serve(ShortMessageCenter shortMessages) {
        center = shortMessages;
        submissions = new SubmitHandler(shortMessages);
    }

    /** Sets the applications that may bind from now on; at first, any on this machine. */
    public void admit(SmppUsers admitted) {
        users = admitted;
    }

    /** Delivers to the bound applications. */
    public EsmeRoutes routes() {
        return routes;
    }

    /** A connection was opened; the session identifies it in the other methods. */
    public EsmeSession opened(SmppPort port, String address, boolean isLocal) {
        return new EsmeSession(this, port, address, isLocal);
    }

    public void received(EsmeSession session, ByteBuffer octets) {
        session.received(octets);
    }

    /** The connection was closed by the peer, or is broken. */
    public void closed(EsmeSession session, String reason) {
        LOG.log(session.state().isBound() ? Level.INFO : Level.DEBUG, "{0}: gone, {1}", session, reason);
        session.closed();
    }

    public int boundSessions() {
        return sessions;
    }

    /** To be called on every change of state of every message. */
    public void changed(ShortMessage message, MessageState state) {
        statuses.changed(message, state, center.now());
    }

    void bound(EsmeSession session, Optional<AddressRange> range) {
        sessions++;
        LOG.log(
                Level.INFO,
                "{0}: bound as {1}{2}",
                session,
                session.state(),
                range.map(numbers -> ", serves " + numbers).orElse(""));
        if (!session.state().receives()) {
            return;
        }
        routes.add(session, range);
        // Destinations blocked by a full session, or by one that is dead without notice, have room here.
        routes.roomOn(session, range, this);
        center.available(new Destination.Esme(session.systemId()));
        range.ifPresent(numbers -> {
            if (numbers.exact().isPresent()) {
                center.available(numbers.exact().get());
            } else {
                center.available(
                        each -> each instanceof Destination.Number number && numbers.contains(number.number()));
            }
        });
    }

    void unbound(EsmeSession session, Optional<AddressRange> range) {
        sessions--;
        routes.remove(session, range);
    }

    /** A session has ended without answering; another one may serve the same destination. */
    void tryAgain(Destination destination) {
        if (routes.serve(destination)) {
            center.available(destination);
        }
    }

    Timers timers() {
        return timers;
    }

    SmppUsers users() {
        return users;
    }

    ShortMessageCenter center() {
        return center;
    }

    SubmitHandler submissions() {
        return submissions;
    }

    MessageStatusStore statuses() {
        return statuses;
    }
}
