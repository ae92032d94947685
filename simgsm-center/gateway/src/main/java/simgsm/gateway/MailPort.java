package simgsm.gateway;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.InstantSource;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.gateway.esme.TcpProtocol;
import simgsm.gateway.mail.MailGateway;
import simgsm.gateway.mail.MailTransport;
import simgsm.net.Acceptor;
import simgsm.net.Connection;
import simgsm.net.ConnectionLimits;
import simgsm.net.Connector;
import simgsm.station.StationThread;

/** Gives the core of mail its sockets and its time. Belongs to the stations' thread. */
final class MailPort implements MailTransport {
    private static final int MOST_CLIENTS = 100;
    private static final int MOST_OF_ONE_ADDRESS = 20;

    private final StationThread thread;
    private final MailOptions options;
    private final Consumer<GatewayEvent> listener;
    private final CoreTime time;
    private final MailGateway core;
    private final EsmePort application;
    private final Optional<Acceptor> port;

    /** @throws IOException if the port cannot be opened */
    MailPort(StationThread thread, GatewaySettings settings, MailOptions options, Consumer<GatewayEvent> listener)
            throws IOException {
        this.thread = thread;
        this.options = options;
        this.listener = listener;
        time = new CoreTime(thread);
        application = new EsmePort(thread, options.smpp(), GatewayEvent.MAIL, listener);
        core = new MailGateway(time.timers(), InstantSource.system(), options.settings(), this, application);
        port = options.port().isEmpty()
                ? Optional.empty()
                : Optional.of(thread.listen(
                        new InetSocketAddress(settings.bind(), options.port().getAsInt()),
                        new ConnectionLimits(MOST_CLIENTS, MOST_OF_ONE_ADDRESS),
                        endpoint -> new TcpConnection(
                                endpoint,
                                time,
                                core.accepted(endpoint.address().getAddress().getHostAddress()),
                                () -> {})));
    }

    void start() throws InterruptedException {
        application.start(core.application(), time);
    }

    /** The port of mail from outside. */
    Optional<Integer> port() {
        return port.map(Acceptor::port);
    }

    EsmePort application() {
        return application;
    }

    @Override
    public void connect(TcpProtocol client) {
        OneConnection attempt = new OneConnection(client);
        attempt.connector = thread.connector(options.server().orElseThrow(), attempt);
        attempt.connector.start();
    }

    /** A connection to the mail server that is not renewed. */
    private final class OneConnection implements Connector.Listener {
        private final TcpProtocol client;
        private Connector connector;

        OneConnection(TcpProtocol client) {
            this.client = client;
        }

        @Override
        public Connection connected(Connection.Endpoint endpoint) {
            return new TcpConnection(endpoint, time, client, connector::close);
        }

        @Override
        public void failed(String reason) {
            connector.close();
            time.advance();
            InetSocketAddress server = options.server().orElseThrow();
            client.lost("no mail server at " + server.getHostString() + ":" + server.getPort() + ": " + reason);
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
}
