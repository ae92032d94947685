package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.Optional;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.Recipient;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.timer.Timers;

/**
 * The centre's side of SMPP for all applications. A deterministic core on the exchange's thread and timers; whoever calls
 * has moved the timers to the present.
 */
public final class SmppServer {
    static final String SYSTEM_ID = "SimGSM";
    static final int INTERFACE_VERSION = 0x34;

    private static final System.Logger LOG = System.getLogger(SmppServer.class.getName());

    private final Timers timers;
    private final EsmeRoutes routes = new EsmeRoutes();
    private final MessageStatusStore fates = new MessageStatusStore();
    private SmppUsers users = SmppUsers.anyLocal();
    private ShortMessageCenter center;
    private SubmitHandler desk;
    private int sessions;

    public SmppServer(Timers timers) {
        this.timers = timers;
    }

    /** The centre knows the routes and these know the centre; so the last arrow is drawn afterwards. */
    public void serve(ShortMessageCenter shortMessages) {
        center = shortMessages;
        desk = new SubmitHandler(shortMessages);
    }

    /** Who may bind from now on; at first anybody on this machine. */
    public void admit(SmppUsers admitted) {
        users = admitted;
    }

    /** The way to the applications. */
    public EsmeRoutes routes() {
        return routes;
    }

    /** An application has connected. The session stands for it in all further calls. */
    public EsmeSession opened(SmppPort port, String address, boolean isLocal) {
        return new EsmeSession(this, port, address, isLocal);
    }

    public void received(EsmeSession session, ByteBuffer octets) {
        session.received(octets);
    }

    /** The connection has ended by the peer's doing, or broke. */
    public void closed(EsmeSession session, String reason) {
        LOG.log(session.state().isBound() ? Level.INFO : Level.DEBUG, "{0}: gone, {1}", session, reason);
        session.closed();
    }

    /** Applications that are bound now. */
    public int boundSessions() {
        return sessions;
    }

    /** To be told of every change of every message. */
    public void changed(ShortMessage message, MessageState state) {
        if (message.esme().isPresent()) {
            fates.changed(message, state, center.now());
        }
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
        // whoever waits for room with a session that is full, or dead unnoticed, has it here
        routes.roomOn(session, range, this);
        center.available(new Recipient.Esme(session.systemId()));
        range.ifPresent(numbers -> {
            if (numbers.exact().isPresent()) {
                center.available(numbers.exact().get());
            } else {
                center.available(
                        receiver -> receiver instanceof Recipient.Number number && numbers.contains(number.number()));
            }
        });
    }

    void unbound(EsmeSession session, Optional<AddressRange> range) {
        sessions--;
        routes.remove(session, range);
    }

    /** A session has gone without answering; another one may serve the same receiver. */
    void tryAgain(Recipient receiver) {
        if (routes.serve(receiver)) {
            center.available(receiver);
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

    SubmitHandler desk() {
        return desk;
    }

    MessageStatusStore fates() {
        return fates;
    }
}
