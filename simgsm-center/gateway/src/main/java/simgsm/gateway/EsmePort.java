package simgsm.gateway;

import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.gateway.esme.Application;
import simgsm.gateway.esme.BindSettings;
import simgsm.net.Connection;
import simgsm.net.Connector;
import simgsm.station.StationThread;

/** Keeps an application bound to the SMSC, and reports its binds. Belongs to the stations' thread. */
final class EsmePort implements Application.Listener {
    private static final System.Logger LOG = System.getLogger(EsmePort.class.getName());
    /** Pause after a refused bind. */
    private static final long REFUSED_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(30);
    /** {@code ready} waits this long for the answer to the first bind. */
    private static final long FIRST_BIND_SECONDS = 3;

    private final StationThread thread;
    private final String kind;
    private final String smscName;
    private final Consumer<GatewayEvent> listener;
    private final CountDownLatch firstBind = new CountDownLatch(1);
    private final SmppOptions options;
    private Application application;
    private Connector smsc;

    /** @param kind {@link GatewayEvent#MAIL} or {@link GatewayEvent#FAX} */
    EsmePort(StationThread thread, SmppOptions options, String kind, Consumer<GatewayEvent> listener) {
        this.thread = thread;
        this.options = options;
        this.kind = kind;
        this.listener = listener;
        smscName = options.smsc().getHostString() + ":" + options.smsc().getPort();
    }

    /** Binds the application, and waits for the first answer. The thread has begun. */
    void start(Application bound, CoreTime time) throws InterruptedException {
        application = bound;
        smsc = thread.connector(options.smsc(), new Connector.Listener() {
            @Override
            public Connection connected(Connection.Endpoint endpoint) {
                return new TcpConnection(endpoint, time, application.connection(), () -> {});
            }

            @Override
            public void failed(String reason) {
                Level level = firstBind.getCount() > 0 ? Level.WARNING : Level.DEBUG;
                LOG.log(level, "SMSC {0}: {1}; trying again", smscName, reason);
                firstBind.countDown();
            }
        });
        thread.execute(smsc::start);
        if (!firstBind.await(FIRST_BIND_SECONDS, TimeUnit.SECONDS)) {
            LOG.log(Level.WARNING, "SMSC {0} does not answer the bind", smscName);
        }
    }

    /** The row of the application, while it is bound. */
    Optional<GatewayEvent> row() {
        return application.isBound()
                ? Optional.of(new GatewayEvent.UserRow(
                        kind, application.settings().number(), smscName, "idle", Optional.empty()))
                : Optional.empty();
    }

    @Override
    public void bound(int status) {
        firstBind.countDown();
        if (status == 0) {
            listener.accept(new GatewayEvent.Joined(kind, application.settings().number(), smscName, Optional.empty()));
        } else {
            smsc.postpone(REFUSED_PAUSE_NANOS);
            BindSettings bind = application.settings();
            String text =
                    "bind of " + bind.systemId() + " for " + bind.addressRange() + " refused, next attempt in 30 s";
            listener.accept(new GatewayEvent.Refused(kind, smscName, status, text));
        }
    }

    @Override
    public void unbound() {
        listener.accept(new GatewayEvent.Left(kind, application.settings().number()));
    }
}
