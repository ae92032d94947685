package simgsm.classroom.demo;

import java.io.IOException;
import java.io.PrintStream;
import java.net.SocketException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.ClassRow;
import simgsm.classroom.session.Consoles;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;
import simgsm.lesson.LessonLibrary;
import simgsm.ui.window.Display;

/**
 * {@code --demo --class N}: a robot for each student in one world, the teacher's windows, and a table of results. Each
 * student's machine starts a phone by the printed command. Without a display the phones run here, and each moves its
 * robot.
 */
public final class ClassDemo implements Consoles.Listener {
    /** Name of SimRobot's console. */
    static final String ROBOTS = "robots";

    /** The centre's events that tell of a phone's user. */
    private static final Set<String> TOLD = Set.of("named", "lesson-result");

    private static final int LEAST_STUDENTS = 2;
    private static final int MOST_STUDENTS = 40;
    private static final String WORLD = "class.map";

    /** Console lines that each phone performs without a display. */
    private static final List<String> MOVES = List.of(
            "wait registered 120",
            "dial {robot}",
            "wait connected 60",
            "wait tone key=1 60",
            "press ** #**20 **",
            "wait tone key=3 60",
            "hangup",
            "wait released cause=16 60");

    final Arguments arguments;
    final CenterSettings settings;
    final ClassRoll roll;
    /** Locked by each thread that uses it. */
    final ClassBoard board = new ClassBoard();

    private final PrintStream out = Program.standardOutput();

    private ClassDemo(Arguments arguments, CenterSettings settings) throws UsageException, SocketException {
        this.arguments = arguments;
        this.settings = settings;
        roll = new ClassRoll((int) arguments.integer("class", 0, LEAST_STUDENTS, MOST_STUDENTS), settings);
        ClassWorld world = new ClassWorld(roll.students());
        for (int i = 0; i < roll.students(); i++) {
            board.add(ClassRoll.name(i), roll.phone(i), roll.robot(i), world.goalXMeters(i), world.goalYMeters(i));
        }
    }

    /** Runs until the centre's window is closed, or without a display until all robots have moved. */
    public static int run(Arguments given, CenterSettings settings, boolean isZoomGiven) throws Exception {
        Arguments arguments = given.without("remember-as", "window");
        ClassDemo demo = new ClassDemo(arguments, settings);
        demo.roll.requireCards();
        try (Session session = Session.open(arguments, folder -> settings)) {
            boolean isHeadless = arguments.has("headless") || !Display.isAvailable();
            session.center().listClass(demo::list);
            session.center().markLessons(LessonLibrary.of(arguments));
            if (isHeadless && (WebLink.isWanted(arguments) || arguments.has("console"))) {
                // The students' phones are browsers, or programs that they start.
                List<String> options = demo.robotOptions(session, Stream.of("--headless"));
                session.consoles().listen(demo);
                List<Event> students = demo.students(session.center().port());
                return WebLink.serve(arguments, session, ROBOTS, options, demo.phoneNumbers(), students);
            }
            demo.printStudents(session.center().port());
            if (isHeadless) {
                return demo.runHeadless(session);
            }
            new ClassWindow(demo, session).run(isZoomGiven);
            demo.printResults();
            return ExitStatus.OK;
        }
    }

    /** The command for each student's machine; none with browsers. */
    private List<Event> students(int port) {
        List<String> hosts = WebLink.isWanted(arguments) ? List.of() : roll.hosts();
        return hosts.stream()
                .flatMap(host -> IntStream.range(0, roll.students())
                        .mapToObj(i -> Event.of("student")
                                .with("number", roll.phone(i))
                                .with("robot", roll.robot(i))
                                .with("command", roll.command(roll.phone(i), host, port))))
                .toList();
    }

    private void printStudents(int port) {
        students(port).forEach(this::print);
        if (!WebLink.isWanted(arguments) && settings.address().isLoopbackAddress()) {
            out.print(ClassroomTexts.in(settings.language()).of("class.bind") + "\n");
            out.flush();
        }
    }

    private List<ClassRow> list() {
        synchronized (board) {
            return board.list();
        }
    }

    @Override
    public void event(String source, Event event) {
        synchronized (board) {
            isHeard(source, event);
        }
    }

    /** Takes an event; with the board's lock held. @return whether a result has changed */
    boolean isHeard(String source, Event event) {
        boolean isTold = source.equals(WebLink.GATEWAY) && event.name().equals("joined")
                || source.equals(Session.CENTRE) && TOLD.contains(event.name());
        return isTold ? board.told(event) : source.equals(ROBOTS) && board.event(event, System.nanoTime());
    }

    void print(Event event) {
        out.print(event + "\n");
        out.flush();
    }

    private void printResults() {
        synchronized (board) {
            board.ranked().forEach(result -> print(result.event()));
        }
    }

    /** The options of SimRobot with the class's world, which is written into the session's folder. */
    private List<String> robotOptions(Session session, Stream<String> more) throws IOException {
        Path file = Files.writeString(session.folder().resolve(WORLD), new ClassWorld(roll.students()).map());
        Stream<String> robots = IntStream.range(0, roll.students())
                .boxed()
                .flatMap(i -> Stream.of("--robot", ClassRoll.name(i) + "=" + roll.robot(i)));
        Stream<String> world = Stream.of("--no-sound", "--world", file.toString());
        return Stream.of(world, robots, more, WebLink.robotOptions(arguments))
                .flatMap(each -> each)
                .toList();
    }

    void startRobots(Session session, Stream<String> more) throws IOException {
        session.start(ROBOTS, "simrobot", roll.robot(0), robotOptions(session, more));
    }

    /** The range of the students' phone numbers, assigned to browsers. */
    Optional<String> phoneNumbers() {
        return Optional.of(roll.phone(0) + "-" + roll.phone(roll.students() - 1));
    }

    private int runHeadless(Session session) throws IOException, InterruptedException {
        DemoTranscript transcript = new DemoTranscript(out) {
            @Override
            public void event(String source, Event event) {
                ClassDemo.this.event(source, event);
            }
        };
        TextBundle texts = ClassroomTexts.in(settings.language());
        Consoles consoles = session.consoles();
        consoles.listen(transcript);
        session.center().start(session.centerEvents());
        int status = ExitStatus.OK;
        String end = texts.of("demo.passed");
        try {
            startRobots(session, Stream.of("--headless"));
            for (int i = 0; i < roll.students(); i++) {
                consoles.perform(ROBOTS + " wait registered 120");
            }
            for (int i = 0; i < roll.students(); i++) {
                session.start(roll.phone(i), "simgsm-phone", roll.phone(i), List.of("--headless", "--no-sound"));
            }
            for (String move : MOVES) {
                for (int i = 0; i < roll.students(); i++) {
                    consoles.perform(roll.phone(i) + " " + move.replace("{robot}", roll.robot(i)));
                }
            }
        } catch (SessionFailure failure) {
            status = ExitStatus.FAILED;
            end = texts.of("demo.failed", failure.getMessage());
        }
        printResults();
        transcript.heading(end);
        return status;
    }
}
