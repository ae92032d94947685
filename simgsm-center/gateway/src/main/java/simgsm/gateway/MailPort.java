package simgsm.gateway;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.gateway.mail.MailGateway;
import simgsm.gateway.mail.MailProtocol;
import simgsm.gateway.mail.MailTransport;
import simgsm.net.Acceptor;
import simgsm.net.Connection;
import simgsm.net.ConnectionLimits;
import simgsm.net.Connector;
import simgsm.station.StationThread;
import simgsm.timer.CivilTime;

/** Gives the core of mail its sockets and its time. Belongs to the stations' thread. */
final class MailPort implements MailTransport {
    private static final System.Logger LOG = System.getLogger(MailPort.class.getName());
    private static final int MOST_CLIENTS = 100;
    private static final int MOST_OF_ONE_ADDRESS = 20;
    /** Pause after a refused bind. */
    private static final long REFUSED_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(30);
    /** {@code ready} waits this long for the answer to the first bind. */
    private static final long FIRST_BIND_SECONDS = 3;

    private final StationThread thread;
    private final MailOptions options;
    private final Consumer<GatewayEvent> listener;
    private final CoreTime time;
    private final MailGateway core;
    private final Connector smsc;
    private final Optional<Acceptor> port;
    private final CountDownLatch firstBind = new CountDownLatch(1);

    /** @throws IOException if the port cannot be opened */
    MailPort(StationThread thread, GatewaySettings settings, MailOptions options, Consumer<GatewayEvent> listener)
            throws IOException {
        this.thread = thread;
        this.options = options;
        this.listener = listener;
        time = new CoreTime(thread);
        core = new MailGateway(time.timers(), new CivilTime(Instant.now(), time.timers()), options.settings(), this);
        smsc = thread.connector(options.smpp(), new Connector.Listener() {
            @Override
            public Connection connected(Connection.Endpoint endpoint) {
                return new MailConnection(endpoint, time, core.application(), () -> {});
            }

            @Override
            public void failed(String reason) {
                Level level = firstBind.getCount() > 0 ? Level.WARNING : Level.DEBUG;
                LOG.log(level, "SMSC {0}: {1}; trying again", smscName(), reason);
                firstBind.countDown();
            }
        });
        port = options.port().isEmpty()
                ? Optional.empty()
                : Optional.of(thread.listen(
                        new InetSocketAddress(settings.bind(), options.port().getAsInt()),
                        new ConnectionLimits(MOST_CLIENTS, MOST_OF_ONE_ADDRESS),
                        endpoint -> new MailConnection(
                                endpoint,
                                time,
                                core.accepted(endpoint.address().getAddress().getHostAddress()),
                                () -> {})));
    }

    /** Binds, and waits for the first answer. The thread has begun. */
    void start() throws InterruptedException {
        thread.execute(smsc::start);
        if (!firstBind.await(FIRST_BIND_SECONDS, TimeUnit.SECONDS)) {
            LOG.log(Level.WARNING, "SMSC {0} does not answer the bind", smscName());
        }
    }

    /** The port of mail from outside. */
    Optional<Integer> port() {
        return port.map(Acceptor::port);
    }

    /** The row of the application, while it is bound. */
    Optional<GatewayEvent> row() {
        return core.isBound()
                ? Optional.of(new GatewayEvent.UserRow(
                        GatewayEvent.MAIL, options.settings().number(), smscName(), "idle", Optional.empty()))
                : Optional.empty();
    }

    private String smscName() {
        return options.smpp().getHostString() + ":" + options.smpp().getPort();
    }

    @Override
    public void connect(MailProtocol client) {
        OneConnection attempt = new OneConnection(client);
        attempt.connector = thread.connector(options.server().orElseThrow(), attempt);
        attempt.connector.start();
    }

    /** A connection to the mail server that is not renewed. */
    private final class OneConnection implements Connector.Listener {
        private final MailProtocol client;
        private Connector connector;

        OneConnection(MailProtocol client) {
            this.client = client;
        }

        @Override
        public Connection connected(Connection.Endpoint endpoint) {
            return new MailConnection(endpoint, time, client, connector::close);
        }

        @Override
        public void failed(String reason) {
            connector.close();
            time.advance();
            client.lost(reason);
        }
    }

    @Override
    public void mailed(String id, String to) {
        listener.accept(new GatewayEvent.Mailed(id, to));
    }

    @Override
    public void failed(String id, String to, String text) {
        listener.accept(new GatewayEvent.MailFailed(id, to, text));
    }

    @Override
    public void refused(String from, int cause, String text) {
        listener.accept(new GatewayEvent.Refused(GatewayEvent.MAIL, from, cause, text));
    }

    @Override
    public void bound(int status) {
        firstBind.countDown();
        if (status == 0) {
            listener.accept(new GatewayEvent.Joined(
                    GatewayEvent.MAIL, options.settings().number(), smscName(), Optional.empty()));
        } else {
            smsc.postpone(REFUSED_PAUSE_NANOS);
            refused(smscName(), status, "bind refused, next attempt in 30 s");
        }
    }

    @Override
    public void unbound() {
        listener.accept(
                new GatewayEvent.Left(GatewayEvent.MAIL, options.settings().number()));
    }
}
