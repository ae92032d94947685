package simgsm.center.app;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import simgsm.air.Msisdn;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.ui.CenterActions;
import simgsm.center.ui.MonitorWindow;
import simgsm.center.ui.NetworkAccess;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.ui.Theme;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.WindowMemory;
import simgsm.ui.window.WindowOptions;
import simgsm.ui.window.WindowPlace;

/** The centre with its window: performs the window's actions and waits for its end. */
public final class CenterWindow implements CenterActions {
    private static final long FIRST_PHONE = 5550101;
    private static final long FIRST_ROBOT = 5550201;

    private final Center center;
    private final Arguments arguments;
    private final ProgramWindow window;
    private final AtomicLong nextPhone = new AtomicLong(FIRST_PHONE);
    private final AtomicLong nextRobot = new AtomicLong(FIRST_ROBOT);
    private final Set<String> cardsGivenOut = new HashSet<>();
    private Set<String> takenNumbers = Set.of();
    private Optional<Runnable> link = Optional.empty();
    private ChildPrograms children;
    private WindowCascade cascade;
    private Optional<String> lesson = Optional.empty();

    /**
     * The surroundings of the centre and its window.
     *
     * @param opened run on the event thread when the window is made
     * @param spoken receives each newly chosen language on the event thread
     * @param mayBeginLesson true if the window's help begins lessons, which end all running programs
     * @param takenNumbers numbers that the window must not assign to started programs
     * @param link action of the window's button for the browsers' link; empty for no such button
     */
    public record Watch(
            Consumer<ExchangeEvent> events,
            Consumer<ExchangeSnapshot> snapshots,
            Runnable opened,
            Consumer<Locale> spoken,
            boolean mayBeginLesson,
            Set<String> takenNumbers,
            Optional<Runnable> link) {
        public static final Watch NONE =
                new Watch(event -> {}, snapshot -> {}, () -> {}, language -> {}, true, Set.of(), Optional.empty());
    }

    private CenterWindow(Center center, Arguments arguments, ProgramWindow window) {
        this.center = center;
        this.arguments = arguments;
        this.window = window;
    }

    /**
     * Shows the window and returns when it is closed.
     *
     * @param children running children that end with the window; null for none
     * @return the lesson chosen by the user, if any
     */
    public static Optional<String> run(
            Center center,
            Arguments arguments,
            CenterSettings settings,
            ChildPrograms children,
            ProgramWindow window,
            Watch watch)
            throws InterruptedException {
        CenterWindow operator = new CenterWindow(center, arguments, window);
        operator.children = children;
        operator.takenNumbers = watch.takenNumbers();
        operator.link = watch.link();
        center.publishSnapshots(watch.snapshots());
        Optional<Console> console =
                arguments.has("console") ? Optional.of(Console.onStandardOutput()) : Optional.empty();
        center.start(console.map(out -> watch.events().andThen(out::tell)).orElse(watch.events()));
        console.ifPresent(out -> {
            out.ready(center.ready());
            window.withConsole(out, arguments, new CenterCommands(center, out));
        });
        if (!arguments.has("lesson")) { // which a pupil has begun
            window.showSheets();
        }
        if (watch.mayBeginLesson()) {
            window.onLesson(operator::beginLesson);
        }
        AtomicBoolean isOpen = new AtomicBoolean();
        window.show(language -> {
            if (isOpen.getAndSet(true)) {
                watch.spoken().accept(language);
            } else {
                watch.opened().run();
            }
            return MonitorWindow.content(operator, CenterTexts.in(language));
        });
        operator.endChildren();
        console.ifPresent(Console::close);
        return operator.chosenLesson();
    }

    private synchronized void beginLesson(String name) {
        lesson = Optional.of(name);
        window.close();
    }

    private synchronized Optional<String> chosenLesson() {
        return lesson;
    }

    @Override
    public int port() {
        return center.port();
    }

    @Override
    public NetworkAccess access() {
        if (center.home().isClosed()) {
            return NetworkAccess.CLOSED;
        }
        return center.isReachedByOthers() ? NetworkAccess.OPEN_TO_OTHERS : NetworkAccess.OPEN;
    }

    @Override
    public Optional<ExchangeSnapshot> snapshot() {
        return Optional.ofNullable(center.snapshot().get());
    }

    @Override
    public Optional<Runnable> link() {
        return link;
    }

    @Override
    public void broadcast(BroadcastOrder order) {
        center.broadcast(order);
    }

    @Override
    public void stopBroadcast(int id) {
        center.stopBroadcast(id);
    }

    @Override
    public void newPhone() throws IOException {
        start("simgsm-phone.jar", nextPhone, WindowCascade::nextPhone);
    }

    @Override
    public void newRobot() throws IOException {
        start("simrobot.jar", nextRobot, places -> places.nextRobot(children.placeOf("simrobot.jar"), Theme.zoom()));
    }

    private String numberFor(AtomicLong next) throws IOException {
        return center.home().isClosed() ? spareCard() : free(next);
    }

    /** A SIM that is not attached, preferably one not assigned before. */
    private synchronized String spareCard() throws IOException {
        Set<String> attached = center.ask(exchange -> exchange.subscribers().stream()
                .filter(Subscriber::isAttached)
                .map(subscriber -> subscriber.number().digits())
                .collect(Collectors.toSet()));
        List<String> spare = center.home().numbers().stream()
                .map(Msisdn::digits)
                .filter(number -> !attached.contains(number) && !takenNumbers.contains(number))
                .toList();
        if (spare.isEmpty()) {
            throw new IOException("every SIM in " + center.home().file().orElseThrow() + " is in use");
        }
        String chosen = spare.stream()
                .filter(number -> !cardsGivenOut.contains(number))
                .findFirst()
                .orElse(spare.get(0));
        cardsGivenOut.add(chosen);
        return chosen;
    }

    /** The next number that has never registered and is not taken. */
    private String free(AtomicLong next) {
        return center.ask(exchange -> {
            String number = Long.toString(next.getAndIncrement());
            while (takenNumbers.contains(number) || exchange.isKnown(new Msisdn(number))) {
                number = Long.toString(next.getAndIncrement());
            }
            return number;
        });
    }

    /** Restarts an ended program unchanged, or starts one with the next free number. */
    private synchronized void start(String jar, AtomicLong next, Function<WindowCascade, WindowPlace> place)
            throws IOException {
        if (children == null) {
            children = ChildPrograms.besideOwn();
        }
        if (children.startAgain(jar).isPresent()) {
            return;
        }
        String number = numberFor(next);
        if (cascade == null) {
            cascade = new WindowCascade(Display.usableArea());
        }
        List<String> words = new ArrayList<>(center.home().wordsFor(number));
        words.addAll(List.of("--center", center.reachedAt(), "--end-with-input"));
        words.addAll(List.of("--window", place.apply(cascade).toString()));
        words.addAll(WindowOptions.presentLook());
        words.addAll(WindowMemory.passedOn(arguments));
        children.start(jar, number, words, ProcessBuilder.Redirect.DISCARD);
    }

    private synchronized void endChildren() {
        if (children != null) {
            children.close();
        }
    }

    @Override
    public void quit() {
        window.close();
    }
}
