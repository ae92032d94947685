package simgsm.classroom.demo;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.app.CenterWindow;
import simgsm.center.app.DataDirectory;
import simgsm.classroom.session.Consoles;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.classroom.ui.ClassActions;
import simgsm.classroom.ui.ClassFrame;
import simgsm.classroom.ui.ClassView;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.classroom.ui.LinkFrame;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simgsm.file.PrivateFiles;
import simgsm.ui.window.Display;
import simgsm.ui.window.WindowOptions;
import simgsm.ui.window.WindowPlace;

/** The teacher's windows of a class: centre, robots, a phone, and the results at the right. */
final class ClassWindow implements ClassActions, Consoles.Listener {
    private static final double SHARE_OF_SCREEN = 0.34;

    private final ClassDemo demo;
    private final ClassRoll roll;
    private final Session session;
    private final String recording;
    /** Each robot's initial x, y and heading. */
    private final Map<String, String> homes = new LinkedHashMap<>();

    private ClassView view = new ClassView(List.of(), ClassView.Phase.FREE, 0, Optional.empty());
    private boolean isChanged = true;
    /** The link that students open in a browser; empty if they start programs. */
    private Optional<String> link = Optional.empty();

    private Optional<String> notice = Optional.empty();
    private long readyNanos;
    /** Language of the class's window. */
    private volatile Locale language;
    /** Owned by the event thread; null until opened. */
    private ClassFrame frame;

    ClassWindow(ClassDemo demo, Session session) throws IOException {
        this.demo = demo;
        this.session = session;
        roll = demo.roll;
        language = demo.settings.language();
        recording = recording(LocalDateTime.now()).toString();
    }

    /** A new file for the recording of this class; earlier ones are kept. */
    private static Path recording(LocalDateTime now) throws IOException {
        Path folder = PrivateFiles.makeFolder(DataDirectory.defaultPath(System.getenv(), System.getProperties())
                .resolve("lessons"));
        String name = "class-" + now.format(DateTimeFormatter.ofPattern("yyyy-MM-dd-HHmm", Locale.ROOT));
        Path file = folder.resolve(name + ".rec");
        for (int another = 2; Files.exists(file); another++) {
            file = folder.resolve(name + "-" + another + ".rec");
        }
        return file;
    }

    /** Blocks until the centre's window is closed. */
    void run(boolean isZoomGiven) throws Exception {
        WindowPlace screen = Display.usableArea();
        int column = (int) (SHARE_OF_SCREEN * screen.width());
        OptionalInt wanted = WindowOptions.zoomPercent(demo.arguments);
        DemoLayout layout = DemoLayout.of(
                        new WindowPlace(screen.x(), screen.y(), screen.width() - column, screen.height()), wanted)
                .saying(isZoomGiven, wanted)
                .withFlatCenter();
        session.consoles().listen(this);
        link = start(layout, layout.phoneColumn(screen));
        Optional<LinkFrame> linkFrame = link.map(url -> new LinkFrame(
                language, url, Optional.of(layout.insteadOfPhone()), locked -> WebLink.lock(session, locked)));
        CenterWindow.Watch watch = new CenterWindow.Watch(
                session.centerEvents(),
                snapshot -> {},
                () -> {
                    frame = ClassFrame.open(
                            demo.settings.language(),
                            screen.x() + screen.width() - column,
                            screen.y(),
                            column,
                            screen.height(),
                            this,
                            this::view);
                    linkFrame.ifPresent(LinkFrame::open);
                },
                chosen -> {
                    language = chosen;
                    frame.speak(chosen);
                },
                false,
                roll.numbers().collect(Collectors.toSet()),
                linkFrame.map(shown -> shown::open));
        CenterWindow.run(
                session.center(),
                demo.arguments,
                demo.settings,
                session.children(),
                layout.centerWindow(demo.arguments),
                watch);
    }

    private Optional<String> start(DemoLayout layout, WindowPlace phone)
            throws IOException, SessionFailure, InterruptedException {
        boolean hasPhone = !demo.settings.home().isClosed()
                || demo.settings.home().numbers().contains(new Msisdn(roll.teacher()));
        if (hasPhone && !WebLink.isWanted(demo.arguments)) {
            List<String> options = layout.options(phone, "--end-with-input");
            session.start("teacher", "simgsm-phone", roll.teacher(), options);
        }
        String word = recording.indexOf(' ') < 0 ? recording : '"' + recording + '"';
        demo.print(Event.of("recording")
                .with("file", recording)
                .with("command", "java -jar simrobot.jar --replay " + word));
        demo.startRobots(session, layout.options(layout.robot(), "--console", "--record", recording).stream());
        Optional<String> link = WebLink.start(demo.arguments, session, ClassDemo.ROBOTS, demo.phoneNumbers());
        link.ifPresent(url -> demo.print(Event.of("link").with("url", url)));
        for (int i = 0; i < roll.students(); i++) {
            session.consoles().perform(ClassDemo.ROBOTS + " @" + ClassRoll.name(i) + " pose");
        }
        return link;
    }

    @Override
    public void event(String source, Event event) {
        synchronized (demo.board) {
            isChanged |= demo.isHeard(source, event);
            if (!source.equals(ClassDemo.ROBOTS)) {
                return;
            }
            if (event.name().equals("ready")) {
                readyNanos = System.nanoTime();
            } else if (event.name().equals("pose")) {
                Map<String, String> fields = event.fields();
                homes.putIfAbsent(
                        fields.getOrDefault("robot", ""),
                        Stream.of("x", "y", "heading")
                                .map(field -> fields.getOrDefault(field, "0"))
                                .collect(Collectors.joining(" ")));
            }
        }
    }

    @Override
    public void lessonChosen(String name) {
        tell(ClassroomTexts.in(language).of("class.lesson.ends", name));
    }

    private void tell(String text) {
        synchronized (demo.board) {
            notice = Optional.of(text);
            isChanged = true;
        }
    }

    /** The same object until a change. */
    private ClassView view() {
        synchronized (demo.board) {
            long seconds = demo.board.seconds(System.nanoTime());
            if (isChanged || seconds != view.seconds()) {
                view = new ClassView(demo.board.rows(), demo.board.phase(), seconds, notice);
                isChanged = false;
                notice = Optional.empty();
            }
            return view;
        }
    }

    /** Switching the motors off ends a robot's motion, so that it can be placed. */
    @Override
    public void start() {
        Map<String, String> places;
        synchronized (demo.board) {
            demo.board.start(System.nanoTime());
            isChanged = true;
            places = new LinkedHashMap<>(homes);
        }
        // without the lock and the event thread, because SimRobot may wait until its events are read
        Runnable placing = () -> places.forEach((robot, place) -> Stream.of("motors off", "place " + place, "motors on")
                .forEach(order -> order(ClassDemo.ROBOTS + " @" + robot + " " + order)));
        new Thread(placing, "class start").start();
    }

    private void order(String line) {
        try {
            session.consoles().perform(line);
        } catch (SessionFailure e) {
            tell(e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void stop() {
        synchronized (demo.board) {
            demo.board.stop(System.nanoTime());
            isChanged = true;
        }
    }

    @Override
    public void replay(String phone) throws IOException {
        long from;
        synchronized (demo.board) {
            from = Math.max(0, demo.board.beganNanos(phone).orElse(readyNanos) - readyNanos);
        }
        List<String> options = replayOptions(recording, TimeUnit.NANOSECONDS.toSeconds(from));
        session.children().start("simrobot.jar", "", options, Redirect.DISCARD);
    }

    /** The options of a SimRobot that replays a recording in the teacher's language, zoom and colours. */
    static List<String> replayOptions(String recording, long fromSeconds) {
        List<String> options = new ArrayList<>(List.of("--replay", recording));
        options.addAll(List.of("--replay-from", String.valueOf(fromSeconds), "--end-with-input"));
        options.addAll(WindowOptions.presentLook());
        return options;
    }

    private String command(String number) {
        return roll.command(number, roll.hosts().get(0), session.center().port());
    }

    @Override
    public List<String> commands() {
        return link.map(List::of)
                .orElseGet(() -> IntStream.range(0, roll.students())
                        .mapToObj(i -> command(roll.phone(i)))
                        .toList());
    }

    @Override
    public String pattern() {
        return link.orElseGet(() -> command("N"));
    }

    @Override
    public boolean isInBrowsers() {
        return link.isPresent();
    }

    @Override
    public Optional<String> warning() {
        TextBundle texts = ClassroomTexts.in(language);
        if (demo.settings.address().isLoopbackAddress()) {
            return Optional.of(texts.of("class.bind"));
        }
        return roll.hosts().size() > 1
                ? Optional.of(texts.of("class.addresses", String.join(", ", roll.hosts())))
                : Optional.empty();
    }
}
