package simgsm.center.app;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.capture.Capture;
import simgsm.center.journal.FileDisk;
import simgsm.center.journal.Journal;
import simgsm.center.journal.JournalThread;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.BroadcastView;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.net.CenterLoop;
import simgsm.center.records.DetailRecords;
import simgsm.center.records.RecordFiles;
import simgsm.center.smpp.SmppServer;
import simgsm.center.web.CenterPages;
import simgsm.center.web.EventCounts;
import simgsm.console.Event;
import simgsm.console.FatalError;
import simgsm.console.HostPort;
import simgsm.event.EventLine;
import simgsm.lesson.LessonLibrary;
import simgsm.net.FirstExchange;
import simgsm.web.WebPort;

/** A running centre: its data directory, its port, its thread. */
public final class Center implements AutoCloseable {
    public static final String NAME = "simgsm-center";

    private static final System.Logger LOG = System.getLogger(Center.class.getName());

    /** 10 snapshots a second. */
    private static final long SNAPSHOT_PERIOD_NANOS = 100_000_000;

    private final DataDirectory data;
    private final Journal journal;
    private final JournalThread store;
    private final CenterLoop loop;
    private static final String ENQUIRE_LINK = "00000010000000150000000000000001";

    private final CenterSettings settings;
    private final InetAddress address;
    private final AtomicReference<ExchangeSnapshot> snapshot = new AtomicReference<>();

    private final OptionalInt smppPort;
    private final SmppServer smpp = new SmppServer();
    private final Optional<Capture> capture;
    private final EventCounts counts = new EventCounts();
    private final Optional<WebPort> web;
    private final Optional<RecordFiles> records;
    private volatile Supplier<List<ClassRow>> classRows = List::of;

    private Center(DataDirectory data, CenterLoop loop, CenterSettings settings) throws IOException {
        this.data = data;
        this.journal = readJournal(data.path());
        this.loop = loop;
        this.store = new JournalThread(journal, this::committed);
        this.settings = settings;
        address = settings.address();
        smpp.admit(SmppUserFile.read(data.path()));
        smppPort = settings.smppPort().isPresent()
                ? OptionalInt.of(loop.openSmpp(address, settings.smppPort().getAsInt(), smpp))
                : OptionalInt.empty();
        capture = settings.capture().isPresent()
                ? Optional.of(Capture.start(settings.capture().get()))
                : Optional.empty();
        capture.ifPresent(loop::captureTo);
        records = settings.records().isPresent()
                ? Optional.of(RecordFiles.in(settings.records().get()))
                : Optional.empty();
        web = settings.httpPort().isPresent()
                ? Optional.of(new WebPort(
                        address,
                        settings.httpPort().getAsInt(),
                        new CenterPages(loop::ask, counts, smpp::boundSessions)))
                : Optional.empty();
    }

    /**
     * Locks the data directory and opens the ports; {@link #start} begins accepting terminals.
     *
     * @throws IOException naming the unavailable directory or port
     */
    public static Center open(CenterSettings settings, Path data, int port) throws IOException {
        InetAddress address = settings.address();
        DataDirectory directory = DataDirectory.take(data);
        try {
            Center center = open(directory, CenterLoop.open(address, port, settings.limits()), settings);
            warnIfOpen(address, settings);
            return center;
        } catch (IOException e) {
            directory.close();
            throw e;
        }
    }

    private static void warnIfOpen(InetAddress address, CenterSettings settings) {
        if (address.isLoopbackAddress()) {
            return;
        }
        if (settings.smppPort().isPresent()) {
            LOG.log(
                    Level.WARNING,
                    "listening on {0}: SMPP passwords and messages cross the network in clear",
                    address.getHostAddress());
        }
        if (settings.home().isClosed()) {
            LOG.log(Level.INFO, "listening on {0}: closed network, nothing is ciphered", address.getHostAddress());
        } else {
            LOG.log(
                    Level.WARNING,
                    "listening on {0}: open network, a terminal that reaches this address may register under any number;"
                            + " --hlr FILE closes it",
                    address.getHostAddress());
        }
    }

    private static Center open(DataDirectory data, CenterLoop loop, CenterSettings settings) throws IOException {
        try {
            return new Center(data, loop, settings);
        } catch (IOException e) {
            loop.close();
            throw e;
        }
    }

    private static Journal readJournal(Path directory) throws IOException {
        try {
            Journal journal = Journal.open(new FileDisk(directory));
            journal.holdReserve();
            return journal;
        } catch (IOException e) {
            throw new IOException("cannot read the messages in " + directory + ": " + e.getMessage(), e);
        }
    }

    private void committed(List<Long> tickets, boolean isDurable) {
        loop.post(exchange -> tickets.forEach(ticket -> exchange.committed(loop.nowNanos(), ticket, isDurable)));
    }

    /** The centre's address for programs on this machine, in the form of {@code --center}. */
    public String reachedAt() {
        InetAddress near = address.isAnyLocalAddress() ? InetAddress.getLoopbackAddress() : address;
        return new HostPort(near.getHostAddress(), port()).toString();
    }

    /** True if it listens on an address that other machines reach. */
    boolean isReachedByOthers() {
        return !address.isLoopbackAddress();
    }

    public int port() {
        return loop.port();
    }

    /** The port for SMPP, if it is served. */
    public OptionalInt smppPort() {
        return smppPort;
    }

    /** The port for HTTP, if it is served. */
    public OptionalInt httpPort() {
        return web.map(port -> OptionalInt.of(port.port())).orElse(OptionalInt.empty());
    }

    public HomeSettings home() {
        return settings.home();
    }

    public void start(Consumer<ExchangeEvent> listener) {
        Instant startedAt = Instant.now().minusNanos(loop.nowNanos());
        Optional<DetailRecords> details = records.map(files -> new DetailRecords(loop::nowNanos, files));
        Exchange exchange = new Exchange(
                new ExchangeSettings(
                        ExchangeSettings.DEFAULT_NETWORK_NAME,
                        settings.random(),
                        startedAt,
                        settings.home().register(),
                        settings.tones(),
                        settings.callWaiting(),
                        settings.language(),
                        settings.speaksUdp(),
                        TimeUnit.SECONDS.toNanos(settings.setupSeconds()),
                        settings.emergencyNumber(),
                        settings.handover()),
                store,
                smpp.routes(),
                event -> {
                    counts.accept(event);
                    details.ifPresent(each -> each.accept(event));
                    listener.accept(event);
                });
        details.ifPresent(each -> exchange.shortMessages().addListener(each::accept));
        smpp.serve(exchange.shortMessages(), exchange.timers());
        exchange.restore(journal.stored());
        FatalError.endOnMachineErrors(NAME);
        store.start(cause -> FatalError.end(NAME, cause));
        loop.start(exchange, cause -> FatalError.end(NAME, cause));
        web.ifPresent(port -> {
            port.start();
            LOG.log(Level.INFO, "metrics on {0}metrics", port.url());
        });
        exchangeFirst();
    }

    private void exchangeFirst() {
        httpPort()
                .ifPresent(port -> FirstExchange.with(
                        address, port, "GET /metrics HTTP/1.0\r\n\r\n".getBytes(StandardCharsets.US_ASCII)));
        smppPort.ifPresent(
                port -> FirstExchange.with(address, port, HexFormat.of().parseHex(ENQUIRE_LINK)));
        if (capture.isEmpty()) {
            // a capture shows terminals only
            FirstExchange.with(address, port(), new byte[0]);
        }
    }

    /** Reports an event to the listener of {@link #start}, on the exchange's thread. */
    public void report(ExchangeEvent event) {
        loop.post(exchange -> exchange.report(event));
    }

    /** Gives the console's command {@code class} its rows. */
    public void listClass(Supplier<List<ClassRow>> rows) {
        classRows = rows;
    }

    /** Sets the lessons whose results phones may tell; those of the suite without a call. */
    public void markLessons(LessonLibrary lessons) {
        loop.post(exchange -> exchange.markLessons(lessons));
    }

    List<Event> classRows() {
        return classRows.get().stream().map(Event::from).toList();
    }

    /**
     * Runs a question on the exchange's thread and returns its answer, or throws its exception.
     *
     * @throws IllegalStateException if the thread has ended or does not answer within 5 s
     */
    <T> T ask(Function<Exchange, T> question) {
        return loop.ask(question);
    }

    /**
     * Broadcasts a text to all attached subscribers.
     *
     * @throws IllegalArgumentException naming the fault of the order
     */
    BroadcastView broadcast(BroadcastOrder order) {
        return ask(exchange -> exchange.broadcast(loop.nowNanos(), order));
    }

    /** The first event of a console, with the open ports. */
    public Event ready() {
        return withPort(withPort(Event.of("ready").with("port", port()), "smpp", smppPort()), "http", httpPort());
    }

    private static Event withPort(Event event, String name, OptionalInt port) {
        return port.isPresent() ? event.with(name, port.getAsInt()) : event;
    }

    /** Answer to {@code handover}; margin in dB. */
    @EventLine("handover algorithm= margin=")
    public record HandoverChosen(String algorithm, int margin) {}

    /**
     * Sets the handover algorithm of calls over towers, from their next traffic channel on.
     *
     * @param text as for {@code --handover}
     * @return the choice as an event
     * @throws IllegalArgumentException naming the expected text
     */
    public Event setHandover(String text) {
        HandoverAlgorithm algorithm = HandoverAlgorithm.of(text);
        ask(exchange -> {
            exchange.setHandover(algorithm);
            return true;
        });
        return Event.from(new HandoverChosen(text, algorithm.marginDecibels()));
    }

    /** @return false if no repeated broadcast has this id */
    boolean stopBroadcast(int id) {
        return ask(exchange -> exchange.stopBroadcast(id));
    }

    /**
     * Updates {@link #snapshot} from now on, at most 10 times a second, and passes each to a listener on the exchange's
     * thread. Called before {@link #start}.
     */
    public void publishSnapshots(Consumer<ExchangeSnapshot> listener) {
        loop.observe(SNAPSHOT_PERIOD_NANOS, exchange -> {
            ExchangeSnapshot newest = exchange.snapshot();
            snapshot.set(newest);
            listener.accept(newest);
        });
    }

    AtomicReference<ExchangeSnapshot> snapshot() {
        return snapshot;
    }

    @Override
    public void close() {
        web.ifPresent(WebPort::close);
        loop.close();
        capture.ifPresent(Capture::close);
        records.ifPresent(RecordFiles::close);
        store.close();
        data.close();
    }
}
