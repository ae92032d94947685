package simgsm.center.demo;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.ProcessBuilder.Redirect;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import simgsm.center.app.CenterEventPrinter;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterTexts;
import simgsm.center.app.CenterWindow;
import simgsm.center.app.ChildConsole;
import simgsm.center.app.DataDirectory;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;
import simgsm.ui.lesson.ClassFrame;
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
    private static final long FIRST_PHONE = Long.parseLong(DemoPrograms.PHONE_NUMBER);
    private static final long FIRST_ROBOT = Long.parseLong(DemoPrograms.ROBOT_NUMBER);
    private static final String WORLD = "worlds/office.map";
    /** Of the goal "Exit" in that world, in metres. */
    private static final double GOAL_X = 17.6;

    private static final double GOAL_Y = 6.0;

    private static final int START_SECONDS = 120;
    private static final int ANSWER_SECONDS = 60;
    private static final double SHARE_OF_SCREEN = 0.26;

    private final Arguments arguments;
    private final CenterSettings settings;
    private final int students;
    private final PrintStream out = Program.standardOutput();
    private final ClassBoard board = new ClassBoard(GOAL_X, GOAL_Y);
    private volatile List<List<String>> rows = List.of();

    private ClassDemo(Arguments arguments, CenterSettings settings) throws UsageException {
        this.arguments = arguments;
        this.settings = settings;
        students = (int) arguments.integer("class", 1, 1, MOST_STUDENTS);
        for (int i = 0; i < students; i++) {
            board.add(name(i), phone(i), robot(i));
        }
        refresh();
    }

    private static String name(int student) {
        return "robot" + (student + 1);
    }

    private static String phone(int student) {
        return Long.toString(FIRST_PHONE + student);
    }

    private static String robot(int student) {
        return Long.toString(FIRST_ROBOT + student);
    }

    /** Runs until the centre's window is closed, or without a display until all robots have moved. */
    public static int run(Arguments given, CenterSettings settings) throws Exception {
        Arguments arguments = given.without("remember-as", "window");
        ClassDemo demo = new ClassDemo(arguments, settings);
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            demo.printStudents(programs);
            return arguments.has("headless") || !Display.isAvailable()
                    ? demo.runHeadless(programs)
                    : demo.runWindowed(programs);
        }
    }

    /** What each student's machine starts. */
    private void printStudents(DemoPrograms programs) throws SocketException {
        for (String host : hosts()) {
            String center = new HostPort(host, programs.center().port()).toString();
            for (int i = 0; i < students; i++) {
                String card = settings.home().isClosed() ? " --sim " + phone(i) + ".sim" : "";
                out.print(Event.of("student")
                                .with("number", phone(i))
                                .with("robot", robot(i))
                                .with(
                                        "command",
                                        "java -jar simgsm-phone.jar --number " + phone(i) + " --center " + center
                                                + card)
                        + "\n");
            }
        }
        if (settings.address().isLoopbackAddress()) {
            out.print(CenterTexts.in(settings.language()).of("class.bind") + "\n");
        }
        out.flush();
    }

    /** The addresses at which the students' machines find the centre. */
    private List<String> hosts() throws SocketException {
        if (!settings.address().isAnyLocalAddress()) {
            return List.of(settings.address().getHostAddress());
        }
        List<String> hosts = NetworkInterface.networkInterfaces()
                .flatMap(NetworkInterface::inetAddresses)
                .filter(address -> address instanceof Inet4Address && !address.isLoopbackAddress())
                .map(InetAddress::getHostAddress)
                .toList();
        return hosts.isEmpty() ? List.of(InetAddress.getLoopbackAddress().getHostAddress()) : hosts;
    }

    private Process startRobots(DemoPrograms programs, String... more) throws IOException {
        List<String> options = new ArrayList<>(List.of("--no-sound", "--world", WORLD));
        for (int i = 0; i < students; i++) {
            options.addAll(List.of("--robot", name(i) + "=" + robot(i)));
        }
        options.addAll(List.of(more));
        return programs.start("simrobot.jar", robot(0), Redirect.PIPE, options);
    }

    private synchronized void event(Event event) {
        if (board.event(event, System.nanoTime())) {
            refresh();
        }
    }

    private void refresh() {
        rows = board.ranked().stream().map(ClassBoard.Result::cells).toList();
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

    /** The recording of the class, for a replay of the best runs; the one before is overwritten. */
    private static Path recording() throws IOException {
        Path folder = DataDirectory.defaultPath(System.getenv(), System.getProperties())
                .resolve("lessons");
        return Files.createDirectories(folder).resolve("class.rec");
    }

    private int runWindowed(DemoPrograms programs) throws Exception {
        WindowPlace screen = Display.usableArea();
        int column = (int) (SHARE_OF_SCREEN * screen.width());
        DemoLayout layout = DemoLayout.of(
                new WindowPlace(screen.x(), screen.y(), screen.width() - column, screen.height()),
                ProgramWindow.zoomPercent(arguments));
        String zoom = String.valueOf(layout.zoomPercent());
        programs.startPhone(
                Redirect.DISCARD,
                "--end-with-input",
                "--zoom",
                zoom,
                "--window",
                layout.phone().toString());
        String recording = recording().toString();
        out.print(Event.of("recording")
                        .with("file", recording)
                        .with("command", "java -jar simrobot.jar --replay " + recording)
                + "\n");
        out.flush();
        new ChildConsole(
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
        ProgramWindow window = ProgramWindow.of(
                arguments.with("zoom", zoom).with("window", layout.center().toString()), Optional.empty());
        CenterWindow.Watch watch = new CenterWindow.Watch(
                event -> {},
                snapshot -> {},
                () -> ClassFrame.open(
                        settings.language(),
                        screen.x() + screen.width() - column,
                        screen.y(),
                        column,
                        screen.height(),
                        () -> rows),
                false);
        CenterWindow.run(programs.center(), arguments, settings, programs.children(), window, watch);
        printResults();
        return ExitStatus.OK;
    }

    private int runHeadless(DemoPrograms programs) throws IOException, InterruptedException {
        DemoTranscript transcript = new DemoTranscript(out);
        TextBundle texts = CenterTexts.in(settings.language());
        programs.center()
                .start(event ->
                        transcript.line("centre", CenterEventPrinter.of(event).toString()));
        DemoConsole robots = new DemoConsole("robots", startRobots(programs, "--headless"), transcript, this::event);
        List<Optional<DemoFailure>> failures = new ArrayList<>();
        try {
            for (int i = 0; i < students; i++) {
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
        for (int i = 0; i < students; i++) {
            Process phone =
                    programs.start("simgsm-phone.jar", phone(i), Redirect.PIPE, List.of("--headless", "--no-sound"));
            phones.add(new DemoConsole(phone(i), phone, transcript, event -> {}));
        }
        List<Optional<DemoFailure>> failures = new ArrayList<>();
        CountDownLatch done = new CountDownLatch(students);
        for (int i = 0; i < students; i++) {
            int student = i;
            Thread thread = new Thread(
                    () -> {
                        Optional<DemoFailure> failure = move(phones.get(student), robot(student));
                        synchronized (failures) {
                            failures.add(failure);
                        }
                        done.countDown();
                    },
                    "student " + phone(i));
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
