package simgsm.classroom.demo;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.ProcessBuilder.Redirect;
import java.net.SocketException;
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
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterTexts;
import simgsm.center.app.CenterWindow;
import simgsm.center.app.ChildConsole;
import simgsm.center.app.DataDirectory;
import simgsm.classroom.ui.ClassActs;
import simgsm.classroom.ui.ClassFrame;
import simgsm.classroom.ui.ClassView;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;
import simgsm.file.PrivateFiles;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.WindowPlace;

/**
 * {@code --demo --class N}: a robot for each student in one world, the teacher's windows, and a table of results. Each
 * student's own machine starts a phone by the command that is printed here. Without a display the phones run here, and each
 * moves its robot.
 */
public final class ClassDemo {
    private static final int MOST_STUDENTS = 30;
    private static final String WORLD = "worlds/office.map";
    /** Of the goal "Exit" in that world, in metres. */
    private static final double GOAL_X = 17.6;

    private static final double GOAL_Y = 6.0;

    private static final int START_SECONDS = 120;
    private static final int ANSWER_SECONDS = 60;
    private static final double SHARE_OF_SCREEN = 0.26;

    private final Arguments arguments;
    private final CenterSettings settings;
    private final ClassRoll roll;
    private final PrintStream out = Program.standardOutput();
    private final ClassBoard board = new ClassBoard(GOAL_X, GOAL_Y);
    /** Where each robot stood when the class began, as x, y and heading. */
    private final Map<String, List<String>> homes = new LinkedHashMap<>();

    private ClassView view = new ClassView(List.of(), ClassView.Phase.FREE, 0, Optional.empty());
    private boolean isChanged = true;
    private Optional<String> notice = Optional.empty();
    private long readyNanos;
    /** Of the class's window. */
    private volatile Locale language;
    /** On the event thread, once it is open. */
    private ClassFrame frame;

    private ClassDemo(Arguments arguments, CenterSettings settings) throws UsageException, SocketException {
        this.arguments = arguments;
        this.settings = settings;
        language = settings.language();
        roll = new ClassRoll((int) arguments.integer("class", 1, 1, MOST_STUDENTS), settings);
        for (int i = 0; i < roll.students(); i++) {
            board.add(roll.name(i), roll.phone(i), roll.robot(i));
        }
    }

    /** Runs until the centre's window is closed, or without a display until all robots have moved. */
    public static int run(Arguments given, CenterSettings settings, boolean isZoomGiven) throws Exception {
        Arguments arguments = given.without("remember-as", "window");
        ClassDemo demo = new ClassDemo(arguments, settings);
        demo.roll.requireCards();
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            demo.printStudents(programs);
            return arguments.has("headless") || !Display.isAvailable()
                    ? demo.runHeadless(programs)
                    : demo.runWindowed(programs, isZoomGiven);
        }
    }

    private void printStudents(DemoPrograms programs) {
        for (String host : roll.hosts()) {
            for (int i = 0; i < roll.students(); i++) {
                out.print(Event.of("student")
                                .with("number", roll.phone(i))
                                .with("robot", roll.robot(i))
                                .with(
                                        "command",
                                        roll.command(
                                                roll.phone(i),
                                                host,
                                                programs.center().port()))
                        + "\n");
            }
        }
        if (settings.address().isLoopbackAddress()) {
            out.print(CenterTexts.in(settings.language()).of("class.bind") + "\n");
        }
        out.flush();
    }

    private Process startRobots(DemoPrograms programs, String... more) throws IOException {
        List<String> options = new ArrayList<>(List.of("--no-sound", "--world", WORLD));
        for (int i = 0; i < roll.students(); i++) {
            options.addAll(List.of("--robot", roll.name(i) + "=" + roll.robot(i)));
        }
        options.addAll(List.of(more));
        return programs.start("simrobot.jar", roll.robot(0), Redirect.PIPE, options);
    }

    private synchronized void event(Event event) {
        isChanged |= board.event(event, System.nanoTime());
        String robot = event.fields().getOrDefault("robot", "");
        switch (event.name()) {
            case "ready" -> readyNanos = System.nanoTime();
            case "pose" ->
                homes.putIfAbsent(
                        robot,
                        Stream.of("x", "y", "heading")
                                .map(field -> event.fields().getOrDefault(field, "0"))
                                .toList());
            case "lesson" -> {
                String name = event.fields().getOrDefault("name", "");
                notice = Optional.of(CenterTexts.in(language).of("class.lesson", name));
                isChanged = true;
            }
            default -> {
                // no matter of the class
            }
        }
    }

    /** The same object until something has changed. */
    private synchronized ClassView view() {
        long seconds = board.seconds(System.nanoTime());
        if (isChanged || seconds != view.seconds()) {
            view = new ClassView(board.rows(), board.phase(), seconds, notice);
            isChanged = false;
            notice = Optional.empty();
        }
        return view;
    }

    private synchronized void printResults() {
        board.ranked().forEach(result -> out.print(result.event() + "\n"));
        out.flush();
    }

    /** Reads SimRobot's events in the window's mode. */
    private final class Robots implements ChildConsole.Listener {
        @Override
        public void line(String line) {}

        @Override
        public void event(Event event) {
            ClassDemo.this.event(event);
        }

        @Override
        public void ended() {}
    }

    /** A file for the recording of this class; those of earlier ones stay. */
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

    /** As a shell takes it for one word. */
    private static String word(String path) {
        return path.indexOf(' ') < 0 ? path : '"' + path + '"';
    }

    /** What the window of the class does. */
    private final class Acts implements ClassActs {
        private final DemoPrograms programs;
        private final ChildConsole robots;
        private final String recording;

        private Acts(DemoPrograms programs, ChildConsole robots, String recording) {
            this.programs = programs;
            this.robots = robots;
            this.recording = recording;
        }

        /** The motors' switch ends what a robot does, so that it can be placed. */
        @Override
        public void start() {
            Map<String, List<String>> places;
            synchronized (ClassDemo.this) {
                board.start(System.nanoTime());
                isChanged = true;
                places = new LinkedHashMap<>(homes);
            }
            // Without the lock: SimRobot may wait until its events are taken before it reads on.
            places.forEach((robot, place) -> {
                order("@" + robot + " motors off");
                order("@" + robot + " place " + String.join(" ", place));
                order("@" + robot + " motors on");
            });
        }

        private void order(String line) {
            try {
                robots.command(line);
            } catch (IOException e) {
                synchronized (ClassDemo.this) {
                    notice = Optional.of(String.valueOf(e.getMessage()));
                    isChanged = true;
                }
            }
        }

        @Override
        public void stop() {
            synchronized (ClassDemo.this) {
                board.stop(System.nanoTime());
                isChanged = true;
            }
        }

        @Override
        public void replay(String phone) throws IOException {
            long from;
            synchronized (ClassDemo.this) {
                from = Math.max(0, board.beganNanos(phone).orElse(readyNanos) - readyNanos);
            }
            List<String> options = replayOptions(recording, TimeUnit.NANOSECONDS.toSeconds(from), language);
            programs.children().start("simrobot.jar", "", options, Redirect.DISCARD);
        }

        @Override
        public List<String> commands() {
            return IntStream.range(0, roll.students())
                    .mapToObj(i -> roll.command(
                            roll.phone(i),
                            roll.hosts().get(0),
                            programs.center().port()))
                    .toList();
        }

        @Override
        public String pattern() {
            return roll.command("N", roll.hosts().get(0), programs.center().port());
        }

        @Override
        public Optional<String> warning() {
            TextBundle texts = CenterTexts.in(language);
            if (settings.address().isLoopbackAddress()) {
                return Optional.of(texts.of("class.bind"));
            }
            return roll.hosts().size() > 1
                    ? Optional.of(texts.of("class.addresses", String.join(", ", roll.hosts())))
                    : Optional.empty();
        }
    }

    /** The options of a SimRobot that shows a recording in the teacher's language, zoom and colours. */
    static List<String> replayOptions(String recording, long fromSeconds, Locale language) {
        List<String> options = new ArrayList<>(List.of("--replay", recording));
        options.addAll(List.of("--replay-from", String.valueOf(fromSeconds), "--end-with-input"));
        options.addAll(List.of("--lang", language.getLanguage()));
        options.addAll(ProgramWindow.presentLook());
        return options;
    }

    private int runWindowed(DemoPrograms programs, boolean isZoomGiven) throws Exception {
        WindowPlace screen = Display.usableArea();
        int column = (int) (SHARE_OF_SCREEN * screen.width());
        DemoLayout layout = DemoLayout.of(
                        new WindowPlace(screen.x(), screen.y(), screen.width() - column, screen.height()),
                        ProgramWindow.zoomPercent(arguments))
                .saying(isZoomGiven, ProgramWindow.zoomPercent(arguments));
        String zoom = String.valueOf(layout.zoomPercent());
        if (!settings.home().isClosed() || settings.home().numbers().contains(new Msisdn(roll.teacher()))) {
            List<String> options = List.of(
                    "--end-with-input",
                    "--zoom",
                    zoom,
                    "--window",
                    layout.phone().toString());
            programs.start("simgsm-phone.jar", roll.teacher(), Redirect.DISCARD, options);
        }
        String recording = recording(LocalDateTime.now()).toString();
        out.print(Event.of("recording")
                        .with("file", recording)
                        .with("command", "java -jar simrobot.jar --replay " + word(recording))
                + "\n");
        out.flush();
        ChildConsole robots = new ChildConsole(
                "robots",
                startRobots(
                        programs,
                        "--console",
                        "--record",
                        recording,
                        "--zoom",
                        zoom,
                        "--window",
                        layout.robot().toString()),
                new Robots());
        for (int i = 0; i < roll.students(); i++) {
            robots.command("@" + roll.name(i) + " pose");
        }
        Acts acts = new Acts(programs, robots, recording);
        ProgramWindow window = ProgramWindow.of(
                arguments.with("zoom", zoom).with("window", layout.center().toString()), Optional.empty());
        CenterWindow.Watch watch = new CenterWindow.Watch(
                event -> {},
                snapshot -> {},
                () -> frame = ClassFrame.open(
                        settings.language(),
                        screen.x() + screen.width() - column,
                        screen.y(),
                        column,
                        screen.height(),
                        acts,
                        this::view),
                chosen -> {
                    language = chosen;
                    frame.speak(chosen);
                },
                false,
                roll.numbers().collect(Collectors.toSet()));
        CenterWindow.run(programs.center(), arguments, settings, programs.children(), window, watch);
        printResults();
        return ExitStatus.OK;
    }

    private int runHeadless(DemoPrograms programs) throws IOException, InterruptedException {
        DemoTranscript transcript = new DemoTranscript(out);
        TextBundle texts = CenterTexts.in(settings.language());
        programs.center()
                .start(event -> transcript.line("centre", Event.from(event).toString()));
        DemoConsole robots = new DemoConsole("robots", startRobots(programs, "--headless"), transcript, this::event);
        List<Optional<DemoFailure>> failures = new ArrayList<>();
        try {
            for (int i = 0; i < roll.students(); i++) {
                robots.await(START_SECONDS, "registered");
            }
            failures.addAll(moveAll(programs, transcript));
        } catch (DemoFailure failure) {
            failures.add(Optional.of(failure));
        }
        printResults();
        Optional<DemoFailure> failed =
                failures.stream().flatMap(Optional::stream).findFirst();
        failed.ifPresentOrElse(
                failure -> transcript.heading(texts.of("demo.failed", failure.getMessage())),
                () -> transcript.heading(texts.of("demo.passed")));
        return failed.isPresent() ? ExitStatus.FAILED : ExitStatus.OK;
    }

    /** All students at the same time: each calls its own robot and moves it. */
    private List<Optional<DemoFailure>> moveAll(DemoPrograms programs, DemoTranscript transcript)
            throws IOException, InterruptedException {
        List<DemoConsole> phones = new ArrayList<>();
        for (int i = 0; i < roll.students(); i++) {
            Process phone = programs.start(
                    "simgsm-phone.jar", roll.phone(i), Redirect.PIPE, List.of("--headless", "--no-sound"));
            phones.add(new DemoConsole(roll.phone(i), phone, transcript, event -> {}));
        }
        List<Optional<DemoFailure>> failures = new ArrayList<>();
        CountDownLatch done = new CountDownLatch(roll.students());
        for (int i = 0; i < roll.students(); i++) {
            int student = i;
            Thread thread = new Thread(
                    () -> {
                        Optional<DemoFailure> failure = move(phones.get(student), roll.robot(student));
                        synchronized (failures) {
                            failures.add(failure);
                        }
                        done.countDown();
                    },
                    "student " + roll.phone(i));
            thread.setDaemon(true);
            thread.start();
        }
        if (!done.await(2L * START_SECONDS, TimeUnit.SECONDS)) {
            return List.of(Optional.of(new DemoFailure("the class has not ended")));
        }
        return failures;
    }

    private static Optional<DemoFailure> move(DemoConsole phone, String robot) {
        try {
            phone.await(START_SECONDS, "registered");
            phone.command("dial " + robot);
            phone.await(ANSWER_SECONDS, "connected");
            phone.await(ANSWER_SECONDS, "tone", "key=1");
            phone.command("press ** #**20 **");
            phone.await(ANSWER_SECONDS, "tone", "key=3");
            phone.command("hangup");
            phone.await(ANSWER_SECONDS, "released", "cause=16");
            return Optional.empty();
        } catch (DemoFailure failure) {
            return Optional.of(failure);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.of(new DemoFailure("interrupted"));
        }
    }
}
