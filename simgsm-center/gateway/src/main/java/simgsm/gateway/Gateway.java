package simgsm.gateway;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.console.Event;
import simgsm.console.FatalError;
import simgsm.gateway.sip.SipUser;
import simgsm.station.StationThread;
import simgsm.web.WebPort;
import simgsm.web.WebSocketPath;

/** A running gateway: the users, the thread that owns them, and their ports. */
final class Gateway implements AutoCloseable {
    private final StationThread thread = new StationThread("gateway", cause -> FatalError.end(GatewayMain.NAME, cause));
    private final WebUsers users;
    private final Optional<WebPort> port;
    private final Optional<SipPort> sip;
    private final Optional<MailPort> mail;
    private final Optional<FaxPort> fax;
    private final String key;

    /** @throws IOException if a port cannot be opened or the folder of faxes not be made */
    Gateway(GatewaySettings settings, Consumer<GatewayEvent> listener) throws IOException {
        users = new WebUsers(thread, settings, listener);
        key = settings.key();
        WebSocketPath phone = new WebSocketPath(
                "/phone",
                PhoneSocket.PROTOCOL,
                false,
                PhoneSocket.MOST_OCTETS,
                socket -> new PhoneSocket(socket, users));
        port = settings.hasWeb() ? Optional.of(webPort(settings, phone)) : Optional.empty();
        sip = settings.sip().isPresent() ? Optional.of(new SipPort(thread, settings, listener)) : Optional.empty();
        mail = settings.mail().isPresent()
                ? Optional.of(new MailPort(thread, settings, settings.mail().get(), listener))
                : Optional.empty();
        fax = settings.fax().isPresent()
                ? Optional.of(new FaxPort(thread, settings.fax().get(), settings.language(), listener))
                : Optional.empty();
    }

    private WebPort webPort(GatewaySettings settings, WebSocketPath phone) throws IOException {
        return new WebPort(
                thread::listen,
                new InetSocketAddress(settings.bind(), settings.web()),
                new GatewayPages(this, new RobotPages(settings.robots())),
                List.of(phone),
                true);
    }

    void start() throws InterruptedException {
        thread.start();
        port.ifPresent(WebPort::start);
        if (mail.isPresent()) {
            mail.get().start();
        }
        if (fax.isPresent()) {
            fax.get().start();
        }
    }

    /** The open ports, as {@code ready} prints them. */
    Event ready() {
        Event ready = Event.of("ready");
        if (port.isPresent()) {
            ready = ready.with("web", port.get().port()).with("link", link());
        }
        if (sip.isPresent()) {
            ready = ready.with("sip", sip.get().port());
        }
        Optional<Integer> mailPort = mail.flatMap(MailPort::port);
        return mailPort.isPresent() ? ready.with("mail", mailPort.get()) : ready;
    }

    /** The link for pupils. */
    String link() {
        return port.orElseThrow().url() + "#" + key;
    }

    /** Rows of all users. */
    List<Event> rows() {
        Stream<GatewayEvent> pages = users.all().stream().map(GatewayEvent.UserRow::new);
        Stream<GatewayEvent> phones = sip.stream()
                .flatMap(it -> it.server().users().stream())
                .filter(SipUser::isRegistered)
                .map(GatewayEvent.UserRow::new);
        Stream<GatewayEvent> applications = Stream.of(mail.map(MailPort::application), fax.map(FaxPort::application))
                .flatMap(Optional::stream)
                .flatMap(application -> application.row().stream());
        return Stream.of(pages, phones, applications)
                .flatMap(rows -> rows)
                .map(Event::from)
                .toList();
    }

    /** Ends a user at once. @return false if the number is unused */
    boolean drop(Msisdn number) {
        return users.drop(number) || sip.filter(it -> it.server().drop(number)).isPresent();
    }

    WebUsers users() {
        return users;
    }

    /** Runs a question on the owner thread. */
    <T> T ask(Callable<T> question) {
        return thread.ask(question);
    }

    /** Ends the calls, detaches the users and ends the thread. */
    @Override
    public void close() {
        thread.execute(() -> {
            users.all().forEach(user -> user.end(CloseCode.GOING_AWAY, "the gateway ends"));
            sip.ifPresent(it -> it.server().close());
        });
        port.ifPresent(WebPort::close);
        thread.close();
    }
}
