package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.smpp.SmppAddress;
import simgsm.sms.SmsAddress;
import simgsm.timer.Timers;

/** The centre's side of SMPP for all applications. A deterministic core on the exchange's thread and timers. */
public final class SmppServer {
    static final String SYSTEM_ID = "SimGSM";

    private static final System.Logger LOG = System.getLogger(SmppServer.class.getName());

    private final EsmeRoutes routes = new EsmeRoutes();
    private final BindLimiter bindLimiter = new BindLimiter();
    private SmppUsers users = SmppUsers.anyLocal();
    private Timers timers;
    private ShortMessageCenter center;
    private MessageRequests requests;
    private int sessions;

    /** Requires a call of {@link #serve}, because the short message centre is created with {@link #routes}. */
    public SmppServer() {}

    /** Connects the server to the short message centre and its timers. Called once, before any connection. */
    public void serve(ShortMessageCenter shortMessages, Timers centersTimers) {
        timers = centersTimers;
        center = shortMessages;
        requests = new MessageRequests(shortMessages, centersTimers);
    }

    /** Sets the applications that may bind from now on; at first, any on this machine. */
    public void admit(SmppUsers admitted) {
        users = admitted;
    }

    /** Delivers to the bound applications. */
    public EsmeRoutes routes() {
        return routes;
    }

    /** A connection was opened. */
    public EsmeSession opened(SmppPort port, String address, boolean isLocal) {
        return new EsmeSession(this, port, address, isLocal);
    }

    public int boundSessions() {
        return sessions;
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
        // destinations blocked by a full or dead session have space here
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

    /** True if an application may serve and send as a number, or send as a name. */
    boolean permits(String systemId, String value) {
        boolean isSubscribers = new SmppAddress(SmsAddress.INTERNATIONAL, 0, value)
                .number()
                .filter(center::isSubscriber)
                .isPresent();
        return users.owners().permits(systemId, value, isSubscribers);
    }

    Timers timers() {
        return timers;
    }

    SmppUsers users() {
        return users;
    }

    BindLimiter bindLimiter() {
        return bindLimiter;
    }

    MessageRequests requests() {
        return requests;
    }

    ShortMessageCenter center() {
        return center;
    }
}
