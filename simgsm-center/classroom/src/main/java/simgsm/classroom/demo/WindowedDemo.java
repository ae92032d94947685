package simgsm.classroom.demo;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicReference;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterWindow;
import simgsm.classroom.session.Consoles;
import simgsm.classroom.session.Session;
import simgsm.classroom.ui.LinkFrame;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.WindowMemory;
import simgsm.ui.window.WindowOptions;
import simgsm.ui.window.WindowPlace;

/**
 * The demo with a display: three windows that do not overlap, ready to dial; closing the centre's window ends all
 * programs.
 */
public final class WindowedDemo {
    /** The names under which the windows of centre, phone and robot are remembered. */
    public static final String CENTER = "demo-center";

    private static final String PHONE = "demo-phone";
    private static final String ROBOT = "demo-robot";

    private WindowedDemo() {}

    /**
     * @param isZoomGiven true if the command line sets the zoom; a remembered zoom is reduced without a notice
     * @return the lesson chosen in one of the windows, if any
     */
    public static Optional<String> run(Arguments arguments, CenterSettings settings, boolean isZoomGiven)
            throws Exception {
        OptionalInt wanted = WindowOptions.zoomPercent(arguments);
        // Centre and desktop libraries load at the same time; the other programs start before the centre's window. The
        // thread that loads the desktop must be the main one: X11 desktops group windows by its class (WM_CLASS).
        FutureTask<Session> opening = new FutureTask<>(() -> Session.open(arguments, folder -> settings));
        new Thread(opening, "opening of the demo").start();
        WindowPlace screen = Display.usableArea();
        try (Session session = result(opening)) {
            Optional<DemoLayout> left = asLeft(arguments);
            DemoLayout layout = left.isPresent() ? left.get() : DemoLayout.of(screen, wanted);
            layout.saying(isZoomGiven, wanted);
            CompletableFuture<ProgramWindow> opened = new CompletableFuture<>();
            AtomicReference<String> lesson = new AtomicReference<>();
            session.consoles().listen(new Consoles.Listener() {
                @Override
                public void lessonChosen(String name) {
                    lesson.set(name);
                    opened.thenAccept(ProgramWindow::close);
                }
            });
            start(
                    session,
                    layout,
                    left.isPresent() || WebLink.isWanted(arguments) ? layout.phone() : layout.phoneColumn(screen),
                    arguments);
            Optional<LinkFrame> link = WebLink.start(arguments, session, "robot", Optional.empty())
                    .map(url -> new LinkFrame(
                            settings.language(),
                            url,
                            Optional.of(layout.belowPhone(screen)),
                            locked -> WebLink.lock(session, locked)));
            // the phone gets the keyboard, because the user dials first
            ProgramWindow window = layout.centerWindow(arguments.with("unfocused", ""));
            opened.complete(window);
            CenterWindow.Watch watch = new CenterWindow.Watch(
                    event -> {},
                    snapshot -> {},
                    () -> link.ifPresent(LinkFrame::open),
                    language -> {},
                    true,
                    Set.of(),
                    link.map(shown -> shown::open));
            return CenterWindow.run(session.center(), arguments, settings, session.children(), window, watch)
                    .or(() -> Optional.ofNullable(lesson.get()));
        }
    }

    /** Starts phone and robot; on one machine only the phone plays each tone. */
    private static void start(Session session, DemoLayout layout, WindowPlace phonePlace, Arguments arguments)
            throws IOException {
        List<String> phone = layout.options(phonePlace, "--console", "--remember-as", PHONE);
        session.start("phone", "simgsm-phone", Session.PHONE_NUMBER, phone);
        List<String> robot = new ArrayList<>(layout.options(
                layout.robot(),
                "--no-sound",
                "--speak",
                "--unfocused",
                "--console",
                "--world",
                HeadlessDemo.WORLD,
                "--remember-as",
                ROBOT));
        WebLink.robotOptions(arguments).forEach(robot::add);
        session.start("robot", "simrobot", Session.ROBOT_NUMBER, robot);
    }

    private static Session result(FutureTask<Session> opening) throws Exception {
        try {
            return opening.get();
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception cause ? cause : e;
        }
    }

    /** The layout of the last demo, if all three windows are remembered on these screens and at one zoom. */
    private static Optional<DemoLayout> asLeft(Arguments arguments) throws UsageException {
        Optional<WindowPlace> phone = WindowMemory.place(arguments, PHONE);
        Optional<WindowPlace> robot = WindowMemory.place(arguments, ROBOT);
        Optional<WindowPlace> center = WindowMemory.place(arguments, CENTER);
        OptionalInt zoom = WindowOptions.zoomPercent(arguments);
        return phone.isPresent() && robot.isPresent() && center.isPresent() && zoom.isPresent()
                ? Optional.of(new DemoLayout(phone.get(), robot.get(), center.get(), zoom.getAsInt()))
                : Optional.empty();
    }
}
