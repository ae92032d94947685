package blackbox.face;

import blackbox.Scenario;
import blackbox.VirtualPhone;
import blackbox.VirtualSuite;
import java.awt.Component;
import java.awt.Container;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.cells.ui.TownPanel;
import simgsm.cells.ui.TownWindow;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.ui.CenterActions;
import simgsm.center.ui.MonitorPanel;
import simgsm.center.ui.MonitorWindow;
import simgsm.center.ui.NetworkAccess;
import simgsm.classroom.ui.ClassActions;
import simgsm.classroom.ui.ClassPanel;
import simgsm.classroom.ui.ClassView;
import simgsm.classroom.ui.LessonActions;
import simgsm.classroom.ui.LessonPanel;
import simgsm.classroom.ui.LessonView;
import simgsm.console.TextBundle;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonException;
import simgsm.lesson.LessonLibrary;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.ui.HandsetControls;
import simgsm.phone.ui.HandsetWindow;
import simgsm.scope.ToneTracer;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneExperiment;
import simgsm.ui.ComponentNames;
import simgsm.ui.lesson.LessonList;
import simgsm.ui.lesson.SheetPanel;
import simgsm.ui.scope.ToneScopePanel;
import simgsm.ui.window.ProgramWindow;
import simrobot.control.LoggedEvent;
import simrobot.control.RobotEventLog;
import simrobot.replay.TimelineMarker;
import simrobot.ui.OpenPort;
import simrobot.ui.OperatorActions;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.Timeline;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.panel.SimRobotWindow;
import simrobot.world.WorldReader;

/** The suite's windows; phone, robot and centre after a call with an order, a refused order, and a short message; without frames. */
final class SuiteWindows {
    private final VirtualPhone caller;
    private final ExchangeSnapshot center;
    private final WindowSnapshot robot;
    private final WindowSnapshot replay;
    private final TownScene town = new TownScene();

    /** Which window. */
    enum Which {
        PHONE,
        ROBOT,
        REPLAY,
        CENTER,
        TOWN,
        CLASS,
        SCOPE,
        LESSONS,
        LESSON,
        SHEET
    }

    SuiteWindows() {
        VirtualSuite suite;
        try {
            suite = new VirtualSuite(WorldReader.read(Scenario.world("demo.map")), 0, Locale.ENGLISH);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        RobotEventLog log = new RobotEventLog(suite.simulation::timeNanos);
        suite.telephone.listen(event -> log.add("robot", event));
        caller = suite.phone(VirtualSuite.PHONE);
        caller.message("5550299", "** #**20 **");
        suite.seconds(2);
        caller.dial(VirtualSuite.ROBOT);
        suite.seconds(1);
        caller.press("**#**20**");
        suite.seconds(6);
        caller.press("**9");
        suite.seconds(3);
        center = suite.exchange().snapshot();
        TelephoneSnapshot line = new TelephoneSnapshot(
                suite.telephone.name(),
                suite.telephone.number().digits(),
                suite.telephone.modem(),
                suite.telephone.heard(),
                suite.telephone.veriCommand(),
                "1637",
                "",
                false);
        robot = snapshot(suite, List.of(line), log.newest(), Optional.empty());
        List<TimelineMarker> markers = List.of(
                new TimelineMarker(3_000_000_000L, TimelineMarker.Kind.CALL, "robot", "call robot=robot from=5550100"),
                new TimelineMarker(
                        5_000_000_000L, TimelineMarker.Kind.COLLISION, "robot", "status robot=robot value=Collision"));
        replay = snapshot(
                suite, List.of(), log.newest(), Optional.of(new Timeline(0, suite.simulation.timeNanos(), markers)));
    }

    private static WindowSnapshot snapshot(
            VirtualSuite suite, List<TelephoneSnapshot> lines, List<LoggedEvent> events, Optional<Timeline> timeline) {
        return new WindowSnapshot(
                suite.simulation.snapshot(),
                lines,
                1,
                false,
                Path.of("worlds", "demo.map"),
                "",
                List.of(new OpenPort("P2OS", "robot", 8101), new OpenPort("HTTP", "", 8080)),
                events,
                timeline,
                Optional.empty(),
                false);
    }

    JComponent open(Which which, String language) {
        return open(which, language, forms(which).get(0));
    }

    /**
     * On the event thread, in the theme that is installed.
     *
     * @param form for a lesson and a sheet the lesson's name
     */
    JComponent open(Which which, String language, String form) {
        Locale locale = Locale.forLanguageTag(language);
        return switch (which) {
            case TOWN ->
                new TownPanel(
                        TownWindow.texts(locale),
                        town.actions(),
                        town.actions().snapshot(),
                        town.propagation(),
                        task -> {},
                        Runnable::run);
            case CLASS -> classPanel(locale);
            case SCOPE -> scope(locale);
            case LESSONS ->
                new LessonList(
                        LessonLibrary.ofSuite(), locale, true, IdleProgram.behind(LessonList.Actions.class, Map.of()));
            case LESSON -> lesson(form, locale);
            case SHEET -> sheet(form, locale);
            default -> program(which, language);
        };
    }

    /** A lesson that is done, with programs at work and the hints of all steps. */
    private static LessonPanel lesson(String name, Locale locale) {
        try {
            LessonLibrary library = LessonLibrary.ofSuite();
            Lesson lesson = library.lesson(name);
            LessonPanel panel = new LessonPanel(
                    lesson,
                    library.texts(lesson, locale),
                    library.names(),
                    locale,
                    text -> text,
                    IdleProgram.behind(LessonActions.class, Map.of()));
            List<LessonView.StepView> steps = lesson.steps().stream()
                    .map(step -> new LessonView.StepView(step.name(), LessonView.StepState.DONE, true, ""))
                    .toList();
            panel.show(new LessonView(
                    9999,
                    true,
                    steps,
                    Set.of("phone3"),
                    "Saved as /home/student/.local/share/simgsm/lessons/call-by-message-9999-Ana.txt"));
            lesson.steps()
                    .forEach(step -> ((AbstractButton) ComponentNames.find(panel, "lesson.hint.of." + step.name())
                                    .orElseThrow())
                            .doClick(0));
            return panel;
        } catch (LessonException e) {
            throw new AssertionError(e);
        }
    }

    private static SheetPanel sheet(String name, Locale locale) {
        try {
            return new SheetPanel(LessonLibrary.ofSuite().sheet(name, locale).orElseThrow(), "Sheet");
        } catch (LessonException e) {
            throw new AssertionError(e);
        }
    }

    /** A large scope that hears two keys through noise and a codec. */
    private static ToneScopePanel scope(Locale locale) {
        ToneScopePanel panel = new ToneScopePanel(locale, experiment -> {});
        ToneTracer tracer = new ToneTracer();
        tracer.tryOut(new ToneExperiment(12, -1.5, Optional.of(SpeechCodec.Kind.GSM_FULL_RATE)));
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.FIVE);
        generator.enqueue(DtmfKey.STAR);
        for (int i = 0; i < 14; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        panel.show(tracer.newest());
        return panel;
    }

    private static ClassPanel classPanel(Locale locale) {
        ClassActions actions = IdleProgram.behind(
                ClassActions.class,
                Map.of(
                        "pattern",
                        "java -jar simgsm-phone.jar --number N --center 192.168.178.112:34709",
                        "warning",
                        Optional.of("The centre listens to this machine only.")));
        ClassPanel panel = new ClassPanel(locale, actions, IdleProgram.behind(ClassPanel.Frames.class, Map.of()));
        List<ClassView.Row> rows = IntStream.range(0, 30)
                .mapToObj(i -> new ClassView.Row(
                        List.of(
                                String.valueOf(5550100 + i),
                                "Ada",
                                String.valueOf(5550200 + i),
                                "12",
                                "108",
                                "10",
                                "1234.5",
                                "order",
                                "7 of 8"),
                        i == 0,
                        ""))
                .toList();
        panel.show(new ClassView(rows, ClassView.Phase.RUNNING, 754, Optional.empty()));
        return panel;
    }

    private JComponent program(Which which, String language) {
        Locale locale = Locale.forLanguageTag(language);
        ProgramWindow.Content content = switch (which) {
            case PHONE ->
                new HandsetWindow(
                                in -> texts("simgsm.phone.messages", in.getLanguage()),
                                () -> speaking(language),
                                IdleProgram.behind(HandsetControls.class, Map.of()),
                                spoken -> {})
                        .content(locale);
            case ROBOT ->
                SimRobotWindow.content(
                        "SimRobot", locale, () -> robot, IdleProgram.behind(OperatorActions.class, Map.of()));
            case REPLAY ->
                SimRobotWindow.content(
                        "SimRobot - session.rec",
                        locale,
                        () -> replay,
                        IdleProgram.behind(OperatorActions.class, Map.of()));
            default -> MonitorWindow.content(actions(), texts("simgsm.center.app.messages", language));
        };
        content.closed().run();
        if (content.panel() instanceof MonitorPanel monitor) {
            monitor.show(center);
        }
        return content.panel();
    }

    private HandsetSnapshot speaking(String language) {
        caller.handset().set(caller.handset().snapshot().settings().withLanguage(language));
        return caller.handset().snapshot();
    }

    /**
     * The forms of a window: the phone's open scope and events; SimRobot's sheets, form for a new robot, presentation and editor with a
     * chosen item; the centre as it opens, with the ladder alone, each tab and a chosen message; each lesson and its
     * sheet.
     */
    static List<String> forms(Which which) {
        return switch (which) {
            case PHONE -> List.of("closed", "scope", "events");
            case ROBOT ->
                List.of("plain", "tab.events", "tab.processes", "robot.add", "presentation", "editor", "editor item");
            case REPLAY -> List.of("plain", "tab.events");
            case CENTER -> List.of("ladder", "alone", "tab 0", "tab 1", "tab 2", "tab 3", "message");
            case TOWN, CLASS, LESSONS -> List.of("plain");
            case SCOPE ->
                List.of("plain", "scope.freeze", "scope.cursors", "scope.spectrogram", "scope.predict", "scope.terms");
            case LESSON, SHEET -> LessonLibrary.ofSuite().names();
        };
    }

    static void take(JComponent window, String form) {
        if (form.startsWith("scope.")) {
            ((AbstractButton) ComponentNames.find(window, form).orElseThrow()).doClick(0);
            if (form.equals("scope.predict")) {
                ((AbstractButton) ComponentNames.find(window, "scope.practise").orElseThrow()).doClick(0);
            }
        } else if (form.equals("scope") || form.equals("events")) {
            ((AbstractButton) ComponentNames.find(window, form + ".switch").orElseThrow()).doClick(0);
        } else if (form.startsWith("tab.") || form.equals("robot.add")) {
            ((AbstractButton) ComponentNames.find(window, form).orElseThrow()).doClick(0);
        } else if (form.equals("presentation")) {
            act(window, KeyStroke.getKeyStroke(KeyEvent.VK_F11, 0));
        } else if (form.startsWith("editor")) {
            act(window, KeyStroke.getKeyStroke(KeyEvent.VK_E, InputEvent.CTRL_DOWN_MASK));
            if (form.endsWith("item")) {
                ((JList<?>) ComponentNames.find(window, "editor.items").orElseThrow()).setSelectedIndex(0);
            }
        } else if (form.equals("alone")) {
            ((AbstractButton) ComponentNames.find(window, "ladder.alone").orElseThrow()).doClick(0);
        } else if (form.startsWith("tab")) {
            AbstractButton lists =
                    (AbstractButton) ComponentNames.find(window, "lists.shown").orElseThrow();
            if (!lists.isSelected()) {
                lists.doClick(0);
            }
            tabs(window).setSelectedIndex(form.charAt(form.length() - 1) - '0');
        } else if (form.equals("message")) {
            JList<?> ladder =
                    (JList<?>) ComponentNames.find(window, "ladder.list").orElseThrow();
            int setup = IntStream.range(0, ladder.getModel().getSize())
                    .filter(i ->
                            String.valueOf(ladder.getModel().getElementAt(i)).contains("CP-DATA"))
                    .findFirst()
                    .orElseThrow();
            ladder.setSelectedIndex(setup);
        }
    }

    /** Does what a key of the window does. */
    private static void act(Container container, KeyStroke stroke) {
        for (Component child : container.getComponents()) {
            if (child instanceof JComponent it) {
                Object id = it.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(stroke);
                if (id != null && it.getActionMap().get(id) != null) {
                    it.getActionMap().get(id).actionPerformed(new ActionEvent(it, 0, ""));
                    return;
                }
            }
            if (child instanceof Container inner) {
                act(inner, stroke);
            }
        }
    }

    static JTabbedPane tabs(JComponent window) {
        return (JTabbedPane) ComponentNames.find(window, "tabs").orElseThrow();
    }

    private static TextBundle texts(String bundle, String language) {
        Locale locale = TextBundle.bundleLocale(Locale.forLanguageTag(language));
        return new TextBundle(ResourceBundle.getBundle(bundle, locale), Locale.ROOT);
    }

    private CenterActions actions() {
        return IdleProgram.behind(
                CenterActions.class,
                Map.of(
                        "port",
                        39195,
                        "access",
                        NetworkAccess.OPEN,
                        "link",
                        Optional.of((Runnable) () -> {}),
                        "snapshot",
                        Optional.of(center)));
    }

    /** Sets the size in pixels and lays all out, until nothing moves any more. */
    static void layOut(JComponent window, int width, int height) {
        window.setSize(width, height);
        for (int i = 0; i < 4; i++) {
            layOut(window);
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    static boolean isScrolled(Component component) {
        return SwingUtilities.getAncestorOfClass(JViewport.class, component) != null;
    }
}
