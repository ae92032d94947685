package simgsm.classroom;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.center.CenterLauncher;
import simgsm.center.app.Center;
import simgsm.center.app.CenterCommands;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterWindow;
import simgsm.center.app.DataDirectory;
import simgsm.center.app.NewSims;
import simgsm.classroom.demo.ClassDemo;
import simgsm.classroom.demo.HeadlessDemo;
import simgsm.classroom.demo.QuickDemo;
import simgsm.classroom.demo.WindowedDemo;
import simgsm.classroom.lesson.LessonCheck;
import simgsm.classroom.lesson.WindowedLesson;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.ExitStatus;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.StartErrorWindow;
import simgsm.ui.window.WindowMemory;
import simgsm.ui.window.WindowOptions;

/** Reads the centre's command line and runs the centre, the demo, a class or a lesson. */
public final class SuiteLauncher implements CenterLauncher {
    @Override
    public void launch(String... args) {
        OptionalInt status = QuickDemo.run(args);
        if (status.isPresent()) {
            System.exit(status.getAsInt());
        }
        new Program(Center.NAME, options())
                .showingErrors(StartErrorWindow::show, windowless(args))
                .checking(WindowOptions::check)
                .runAndExit(args, SuiteLauncher::run);
    }

    /** Options of runs without windows; {@code --lessons} with {@code --demo} has windows. */
    private static String[] windowless(String... args) {
        return QuickDemo.isDemo(args)
                ? new String[] {"headless", "new-sim", "check"}
                : new String[] {"headless", "new-sim", "check", "lessons"};
    }

    private static Options options() {
        return Options.read(SuiteLauncher.class.getResourceAsStream("options.txt"))
                .commands(CenterCommands.COMMANDS);
    }

    private static int run(Arguments given) throws Exception {
        if (given.has("new-sim")) {
            return NewSims.make(given);
        }
        if (given.has("lessons") && !given.has("lesson") && !given.has("demo")) {
            return LessonCheck.list(given);
        }
        requireTogether(given, "class", "demo");
        requireTogether(given, "web", "demo");
        requireTogether(given, "check", "lesson");
        requireTogether(given, "result", "check");
        if (given.has("class") && given.has("lesson")) {
            throw new UsageException("--class: the teacher's windows begin no lesson, expected no --lesson");
        }
        if (given.has("check")) {
            return LessonCheck.run(given);
        }
        if (given.has("lesson") && given.has("headless")) {
            throw new UsageException("--lesson with --headless needs --check");
        }
        if (given.has("lesson") && given.has("demo") && !Display.isAvailable()) {
            throw new UnavailableException(
                    "no display is available; without one --lesson NAME --check FILE plays a solution");
        }
        Arguments arguments = recalled(given);
        CenterSettings settings = CenterSettings.read(arguments);
        if (arguments.has("demo")) {
            return demo(arguments, settings, given);
        }
        requireTogether(arguments, "lesson", "demo");
        return center(arguments, settings, given);
    }

    private static int demo(Arguments arguments, CenterSettings settings, Arguments given) throws Exception {
        boolean isZoomGiven = given.has("zoom");
        if (arguments.has("web") && settings.home().isClosed()) {
            throw new UsageException("--web: browsers have no SIM card, expected an open network, without --hlr");
        }
        if (arguments.has("class")) {
            return ClassDemo.run(arguments, settings, isZoomGiven);
        }
        if (arguments.has("lesson")) {
            return lessons(arguments, isZoomGiven, arguments.text("lesson"));
        }
        if (arguments.has("headless") || !Display.isAvailable()) {
            return HeadlessDemo.run(arguments, settings);
        }
        Optional<String> chosen = WindowedDemo.run(arguments, settings, isZoomGiven);
        return lessons(asShown(given), isZoomGiven, chosen);
    }

    private static int center(Arguments arguments, CenterSettings settings, Arguments given) throws Exception {
        Optional<ProgramWindow> window = arguments.has("headless")
                ? Optional.empty()
                : Optional.of(ProgramWindow.of(arguments, Optional.empty()));
        Path data = settings.data().orElseGet(() -> DataDirectory.defaultPath(System.getenv(), System.getProperties()));
        Optional<String> chosen;
        try (Center center = Center.open(settings, data, settings.port().orElse(CenterSettings.DEFAULT_PORT))) {
            if (window.isEmpty()) {
                return runConsole(center, arguments);
            }
            chosen = CenterWindow.run(center, arguments, settings, null, window.get(), CenterWindow.Watch.NONE);
        }
        return chosen.isEmpty() ? ExitStatus.OK : lessons(asShown(given), given.has("zoom"), chosen);
    }

    /** Opens the chosen lesson, then those chosen in its windows. */
    private static int lessons(Arguments arguments, boolean isZoomGiven, Optional<String> first) throws Exception {
        Optional<String> next = first;
        Arguments shown = arguments;
        while (next.isPresent()) {
            next = WindowedLesson.run(shown.without("remember-as", "window").with("lesson", next.get()), isZoomGiven);
            shown = asShown(shown);
        }
        return ExitStatus.OK;
    }

    private static Arguments recalled(Arguments given) throws UsageException {
        return WindowMemory.recall(given, given.has("demo") ? WindowedDemo.CENTER : "center");
    }

    /** With the size, language and colours that were chosen in a window since the start. */
    private static Arguments asShown(Arguments given) throws UsageException {
        Arguments shown = recalled(given);
        List<String> look = WindowOptions.presentLook();
        for (int i = 0; i < look.size(); i += 2) {
            shown = shown.with(look.get(i).substring(2), look.get(i + 1));
        }
        return shown;
    }

    private static void requireTogether(Arguments arguments, String option, String needed) throws UsageException {
        if (arguments.has(option) && !arguments.has(needed)) {
            throw new UsageException("--" + option + " needs --" + needed);
        }
    }

    private static int runConsole(Center center, Arguments arguments) throws Exception {
        try (Console console = Console.onStandardOutput()) {
            center.start(console::tell);
            console.ready(center.ready());
            Program.runConsole(console, arguments, new CenterCommands(center, console));
            return console.exitStatus();
        }
    }
}
