package simgsm.classroom.lesson;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.ThreadLocalRandom;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterWindow;
import simgsm.center.app.DataDirectory;
import simgsm.center.msc.ExchangeEvent;
import simgsm.classroom.demo.DemoLayout;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.classroom.ui.LessonActions;
import simgsm.classroom.ui.LessonFrame;
import simgsm.classroom.ui.LessonPanel;
import simgsm.classroom.ui.LessonView;
import simgsm.console.Arguments;
import simgsm.file.FileReplacement;
import simgsm.file.PrivateFiles;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonLibrary;
import simgsm.lesson.LessonProgram;
import simgsm.lesson.LessonRun;
import simgsm.lesson.LessonTexts;
import simgsm.thread.DaemonThread;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Symbol;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.SuiteWindow;
import simgsm.ui.window.WindowIcon;
import simgsm.ui.window.WindowOptions;
import simgsm.ui.window.WindowPlace;

/** {@code --demo --lesson NAME}: the suite, with the lesson's panel at the right. */
public final class WindowedLesson implements LessonActions, LessonSession.Watcher {
    private static final double SHARE_OF_SCREEN = 0.24;
    private static final int LEAST_WIDTH = 270;
    private static final int MOST_WIDTH = 460;
    private static final int MOST_RANDOM_SEED = 10_000;
    private static final int STEP = 40;
    private static final int PERCENT = 100;
    private static final int LEAST_ZOOM = 55;
    /** Height of a window's title, in pixels. */
    private static final int FRAME = 30;

    private final LessonLibrary library;
    private final Lesson lesson;
    private final LessonTexts texts;
    private final Locale language;
    private final LessonRun run;
    private final LessonSession session;
    private final ProgramWindow window;
    /** Performs actions in order; the first one starts the programs. */
    private final ExecutorService worker = DaemonThread.executor("lesson");

    private volatile LessonView view;
    private volatile String notice = "";
    private volatile String next;
    private LessonFrame frame;

    private WindowedLesson(
            LessonLibrary library,
            LessonTexts texts,
            Locale language,
            LessonRun run,
            LessonSession session,
            ProgramWindow window) {
        this.library = library;
        this.lesson = run.lesson();
        this.texts = texts;
        this.language = language;
        this.run = run;
        this.session = session;
        this.window = window;
    }

    /**
     * Opens the lesson of the arguments, and returns when the centre's window is closed.
     *
     * @return the next lesson chosen by the user, if any
     */
    public static Optional<String> run(Arguments given, boolean isZoomGiven) throws Exception {
        long seed = given.has("seed")
                ? LessonCheck.seed(given)
                : ThreadLocalRandom.current().nextInt(MOST_RANDOM_SEED);
        Arguments arguments = given.with("seed", Long.toString(seed));
        LessonLibrary library = LessonLibrary.of(arguments);
        LessonCheck.Named named = LessonCheck.named(library, arguments);
        Lesson lesson = named.lesson();
        ProgramWindow.of(arguments, Optional.empty()); // throws here without a display
        WindowPlace screen = Display.usableArea();
        WindowPlace place = place(
                screen,
                DemoLayout.of(screen, WindowOptions.zoomPercent(arguments)).zoomPercent());
        DemoLayout layout = DemoLayout.of(
                        new WindowPlace(screen.x(), screen.y(), screen.width() - place.width(), screen.height()),
                        WindowOptions.zoomPercent(arguments))
                .saying(isZoomGiven, WindowOptions.zoomPercent(arguments));
        ProgramWindow window = ProgramWindow.of(
                arguments.with("zoom", String.valueOf(layout.zoomPercent())), Optional.of(layout.center()));
        LessonRun run = new LessonRun(lesson, seed, new LessonFigures());
        try (Session network = LessonNetwork.open(lesson, arguments)) {
            LessonSession session = new LessonSession(
                    run,
                    network,
                    library.folder(lesson.name()),
                    program -> options(program, lesson, layout, screen),
                    arguments.language());
            WindowedLesson opened =
                    new WindowedLesson(library, named.texts(), arguments.language(), run, session, window);
            run.listen(result ->
                    network.center().report(new ExchangeEvent.LessonResult(new Msisdn(Session.PHONE_NUMBER), result)));
            CenterWindow.Watch watch = new CenterWindow.Watch(
                    session.centerEvents(),
                    session.trace(),
                    () -> opened.open(place),
                    language -> {},
                    true,
                    Set.of(),
                    Optional.empty());
            Optional<String> chosen = CenterWindow.run(
                    network.center(), arguments, CenterSettings.read(arguments), network.children(), window, watch);
            opened.end();
            return chosen.or(() -> Optional.ofNullable(opened.next));
        }
    }

    /** The panel's share of the screen's width, for texts of that zoom. */
    private static WindowPlace place(WindowPlace screen, int zoomPercent) {
        double most = MOST_WIDTH * Math.max(1.0, zoomPercent / (double) PERCENT);
        int width = (int) Math.max(LEAST_WIDTH, Math.min(most, SHARE_OF_SCREEN * screen.width()));
        return new WindowPlace(screen.x() + screen.width() - width, screen.y(), width, screen.height());
    }

    /**
     * Options that place a program. Robot and town share a place. Two phones are placed one below the other, small
     * enough for both to be visible; further ones cover the second.
     */
    private static List<String> options(LessonProgram program, Lesson lesson, DemoLayout layout, WindowPlace screen) {
        if (program.options().contains("--headless")) {
            return List.of("--no-sound");
        }
        int before = (int) lesson.programs().stream()
                .takeWhile(each -> !each.equals(program))
                .filter(each -> each.jar().equals(program.jar()))
                .count();
        boolean isPhone = program.jar().equals("simgsm-phone");
        long alike = lesson.programs().stream()
                .filter(each -> each.jar().equals(program.jar()))
                .count();
        int zoom = layout.zoomPercent();
        WindowPlace place = isPhone ? layout.phoneColumn(screen) : layout.robot();
        if (isPhone && alike > 1) {
            int half = screen.height() / 2;
            zoom = Math.min(zoom, Math.max(LEAST_ZOOM, (half - FRAME) * PERCENT / SuiteWindow.PHONE.heightUnits()));
            int height = SuiteWindow.PHONE.heightUnits() * zoom / PERCENT + FRAME;
            int y = Math.max(screen.y(), screen.y() + screen.height() - height);
            place = before == 0
                    ? layout.phone()
                    : new WindowPlace(place.x() + (before - 1) * STEP, y - (before - 1) * STEP, 0, 0);
        }
        List<String> options = List.of("--console", "--zoom", String.valueOf(zoom), "--window", place.toString());
        return isPhone
                ? options
                : Stream.concat(options.stream(), Stream.of("--no-sound")).toList();
    }

    /** Opens the panel; on the event thread, after the theme is installed. */
    private void open(WindowPlace place) {
        refresh();
        session.watch(this);
        LessonPanel panel = new LessonPanel(lesson, texts, library.names(), language, run::shown, this);
        frame = LessonFrame.open(
                DesktopTexts.in(language).of("lessons.title") + ": " + texts.of("title"),
                WindowIcon.images(Symbol.PHONE),
                panel,
                place.x(),
                place.y(),
                place.width(),
                place.height(),
                () -> view);
        perform(() -> {
            notice = ClassroomTexts.in(language).of("lesson.starting");
            refresh();
            try {
                session.start();
            } catch (SessionFailure e) {
                throw new SessionFailure(ClassroomTexts.in(language).of("lesson.start.failed", e.getMessage()));
            }
            notice = "";
        });
    }

    @Override
    public void refused(String action, String why) {
        notice = texts.find("refused " + action).map(run::shown).orElse(why);
        refresh();
    }

    @Override
    public void ended(String program, int status, boolean isFault) {
        if (isFault) {
            notice = faultOf(program, status);
        }
        refresh();
    }

    @Override
    public void idle(String seconds) {
        notice = ClassroomTexts.in(language).of("lesson.idle", seconds);
        refresh();
    }

    private String faultOf(String program, int status) {
        String title = texts.find("program " + program).orElse(program);
        String why = texts.find("refused " + program)
                .map(text -> "\n\n" + run.shown(text))
                .orElse("");
        return ClassroomTexts.in(language).of("lesson.program.ended", title, String.valueOf(status)) + why;
    }

    private void end() {
        worker.shutdownNow();
        if (frame != null) {
            frame.close();
        }
    }

    /** An action that may fail with a text for the student. */
    private interface Act {
        void perform() throws IOException, SessionFailure, InterruptedException;
    }

    private void perform(Act act) {
        worker.execute(() -> {
            try {
                act.perform();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            } catch (IOException | SessionFailure e) {
                notice = e.getMessage();
            }
            refresh();
        });
    }

    @Override
    public void changed() {
        refresh();
    }

    private void refresh() {
        Set<String> running = session.running();
        session.ofRun(each -> view = LessonViews.of(each, running, notice));
    }

    private void line(String line) {
        perform(() -> session.perform(line));
    }

    @Override
    public void predict(String text) {
        line("predict " + text);
    }

    /** Keeps the output of tools visible, because answers are read from it. */
    @Override
    public void answer(String name, String text) {
        line("answer " + name + " " + text);
    }

    @Override
    public void hint(String step) {
        line("hint " + step);
    }

    @Override
    public void act(String name, String input) {
        String working = ClassroomTexts.in(language).of("lesson.working");
        perform(() -> {
            notice = working;
            refresh();
            session.perform("act " + name + " " + input);
            String told = session.told();
            String why = session.hasFailed()
                    ? texts.find("refused " + name)
                            .map(text -> run.shown(text) + "\n\n")
                            .orElse("")
                    : "";
            if (notice.equals(working) || !told.isEmpty()) {
                notice = why + told;
            }
        });
    }

    @Override
    public void startProgram(String name) {
        perform(() -> {
            notice = "";
            session.perform("start " + name);
        });
    }

    @Override
    public void stopProgram(String name) {
        line("stop " + name);
    }

    /** Saves to the folder {@code lessons} of the user's data. */
    @Override
    public void save(String student) {
        perform(() -> {
            Path folder = DataDirectory.defaultPath(System.getenv(), System.getProperties())
                    .resolve("lessons");
            PrivateFiles.makeFolder(folder);
            String who = student.replaceAll("[^\\p{L}\\p{N}]+", "-");
            Path file = folder.resolve(lesson.name() + "-" + run.seed() + (who.isEmpty() ? "" : "-" + who) + ".txt");
            String text = session.ofRun(each -> ResultText.text(each, student, Instant.now(), language));
            FileReplacement.writePrivately(file, text.getBytes(StandardCharsets.UTF_8));
            notice = ClassroomTexts.in(language).of("lesson.saved", file.toString());
        });
    }

    @Override
    public void open(String name) {
        next = name;
        window.close();
    }
}
