package simgsm.center;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.center.app.Center;
import simgsm.center.app.CenterCommands;
import simgsm.center.app.CenterEventPrinter;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterWindow;
import simgsm.center.app.DataDirectory;
import simgsm.center.app.NewSims;
import simgsm.center.capture.CapturePlan;
import simgsm.center.demo.ClassDemo;
import simgsm.center.demo.HeadlessDemo;
import simgsm.center.demo.QuickDemo;
import simgsm.center.demo.WindowedDemo;
import simgsm.center.lesson.LessonCheck;
import simgsm.center.lesson.WindowedLesson;
import simgsm.center.net.PortLimits;
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

/** Starts the centre (M3) from the command line. */
public final class CenterMain {
    private CenterMain() {}

    public static void main(String[] args) {
        OptionalInt status = QuickDemo.run(args);
        if (status.isPresent()) {
            System.exit(status.getAsInt());
        }
        new Program(Center.NAME, options())
                .showingErrors(StartErrorWindow::show, windowless(args))
                .checking(ProgramWindow::check)
                .runAndExit(args, CenterMain::run);
    }

    /** Options without a window; {@code --lessons} with {@code --demo} has windows. */
    private static String[] windowless(String... args) {
        return QuickDemo.isDemo(args)
                ? new String[] {"headless", "new-sim", "check"}
                : new String[] {"headless", "new-sim", "check", "lessons"};
    }

    private static Options options() {
        return Program.commonOptions(
                        "java -jar simgsm-center.jar [OPTION]...",
                        "M3, the SMS/Phone centre: phones and modems register here, call each other and send messages.")
                .commands(CenterCommands.COMMANDS)
                .flag("console", Program.CONSOLE_HELP)
                .flag(
                        "demo",
                        "the whole suite: the centre, one phone and one SimRobot, ready to dial; without a display a"
                                + "\nscripted session whose transcript is printed")
                .value(
                        "class",
                        "N",
                        "with --demo: N robots (5550200 ...) in one world for N students' phones (5550100 ...), the commands"
                                + "\nthat their machines start, and a table of results")
                .optionalValue(
                        "lessons",
                        "DIR",
                        "alone: list the lessons and end; with DIR also a teacher's own, a folder each in it; with --demo or"
                                + "\n--lesson: have these beside those of the suite")
                .value(
                        "lesson",
                        "NAME",
                        "with --check: the lesson to play; with --demo: the lesson to show beside the suite")
                .value(
                        "check",
                        "FILE|right|wrong",
                        "with --lesson: play a solution without windows, print pass or fail for each step, and end: 0 only"
                                + "\nif all passed. right and wrong are the lesson's own; --seed N chooses the student's numbers")
                .value("result", "FILE", "with --check: write the result for the teacher")
                .value(
                        "port",
                        "N",
                        "TCP port for phones and modems, 0 for any free one; default " + CenterSettings.DEFAULT_PORT)
                .value(
                        "smpp",
                        "PORT",
                        "serve applications by SMPP 3.4 on this TCP port, 0 for any free one; who may bind stands in"
                                + "\nsmpp-users.properties in the data directory, id=password a line, and id.SETTING=value;"
                                + "\nwithout that file any application of this machine")
                .value(
                        "tones",
                        "eu|us",
                        "let callers hear ring-back, busy and congestion as the network's own sound, European or"
                                + "\nAmerican; else phones make these tones themselves, as GSM has it")
                .value(
                        "call-waiting",
                        "on|off",
                        "on: a second call is offered to a phone that is in one, and waits; off (default): its caller hears"
                                + "\nthat the number is busy")
                .value("bind", "ADDRESS", "address to listen on; default loopback only")
                .value(
                        "hlr",
                        "FILE",
                        "closes the network: only the SIMs that the file lists may register, and must prove it;"
                                + "\nwithout it the network is open and the number alone names the subscriber")
                .value(
                        "new-sim",
                        "N,N-N,...",
                        "with --hlr: makes SIMs with new keys for these numbers, adds them to the file, writes each"
                                + "\none beside it as NUMBER.sim for --sim of phone and robot, and ends")
                .value(
                        "max-terminals",
                        "N",
                        "connections of phones and modems; default " + PortLimits.STANDARD.terminals())
                .value(
                        "max-terminals-per-address",
                        "N",
                        "of these, from each address other than this machine's; default "
                                + PortLimits.STANDARD.terminalsPerAddress())
                .value("max-applications", "N", "SMPP connections; default " + PortLimits.STANDARD.applications())
                .value(
                        "max-applications-per-address",
                        "N",
                        "of these, from each address other than this machine's; default "
                                + PortLimits.STANDARD.applicationsPerAddress())
                .value("barred-imeis", "IMEI,...", "terminals that may not register (cause 6)")
                .value("data", "DIR", "where messages and subscribers are kept; one process at a time")
                .value(
                        "rtp",
                        "tcp|udp",
                        "udp: the speech of calls goes as RTP over UDP beside the terminal's TCP link, so that Wireshark"
                                + "\nplays it live; tcp (default): within the link")
                .value(
                        "t303",
                        "SECONDS",
                        "how long a called phone may leave SETUP unanswered; then the caller gets cause 18; default 30")
                .value(
                        "handover",
                        "ALGORITHM[,NAME=N]...",
                        "when calls over towers move to another cell: power-budget (default; algorithm 1 of osmo-bsc) with"
                                + "\nlevels=10, neighbours=10 (reports averaged), interval=6 (reports), hysteresis=3 (dB),"
                                + "\ndistance=9999; or strongest-cell with margin=6 (dB), reports=4")
                .value(
                        "http",
                        "PORT",
                        "serve metrics for Prometheus and lists as JSON by HTTP, read-only, on this TCP port, 0 for any"
                                + "\nfree one")
                .value("cdr", "DIR", "write a record of each call and each short message, as CSV, one file a day")
                .value(
                        "capture",
                        "FILE.pcap",
                        "write what crosses the wire, speech too, for Wireshark; port 3003 there whatever --port says")
                .value(
                        "capture-limit",
                        "MIB",
                        "put the capture aside as FILE.1.pcap when it is so large, and begin anew; default "
                                + CapturePlan.DEFAULT_LIMIT_MIB);
    }

    private static int run(Arguments given) throws Exception {
        if (given.has("new-sim")) {
            return NewSims.make(given);
        }
        if (given.has("lessons") && !given.has("lesson") && !given.has("demo")) {
            return LessonCheck.list(given);
        }
        requireTogether(given, "class", "demo");
        requireTogether(given, "check", "lesson");
        requireTogether(given, "result", "check");
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
        Arguments arguments = WindowMemory.recall(given, given.has("demo") ? WindowedDemo.CENTER : "center");
        CenterSettings settings = CenterSettings.read(arguments);
        boolean isHeadless = arguments.has("headless");
        if (arguments.has("demo")) {
            if (arguments.has("class")) {
                return ClassDemo.run(arguments, settings, given.has("zoom"));
            }
            if (!arguments.has("lesson") && (isHeadless || !Display.isAvailable())) {
                return HeadlessDemo.run(arguments, settings);
            }
            return lessons(
                    arguments,
                    given.has("zoom"),
                    arguments.has("lesson")
                            ? arguments.text("lesson")
                            : WindowedDemo.run(arguments, settings, given.has("zoom")));
        }
        requireTogether(arguments, "lesson", "demo");
        Optional<ProgramWindow> window =
                isHeadless ? Optional.empty() : Optional.of(ProgramWindow.of(arguments, Optional.empty()));
        Path data = settings.data().orElseGet(() -> DataDirectory.defaultPath(System.getenv(), System.getProperties()));
        Optional<String> chosen;
        try (Center center = Center.open(settings, data, settings.port().orElse(CenterSettings.DEFAULT_PORT))) {
            if (window.isEmpty()) {
                return runConsole(center, arguments, settings);
            }
            chosen = CenterWindow.run(center, arguments, settings, null, window.get(), CenterWindow.Watch.NONE);
        }
        return lessons(arguments, given.has("zoom"), chosen);
    }

    /** Opens the lesson that was chosen, and those that are chosen in its windows. */
    private static int lessons(Arguments arguments, boolean isZoomGiven, Optional<String> first) throws Exception {
        Optional<String> next = first;
        while (next.isPresent()) {
            next = WindowedLesson.run(
                    arguments.without("remember-as", "window").with("lesson", next.get()), isZoomGiven);
        }
        return ExitStatus.OK;
    }

    private static void requireTogether(Arguments arguments, String option, String needed) throws UsageException {
        if (arguments.has(option) && !arguments.has(needed)) {
            throw new UsageException("--" + option + " needs --" + needed);
        }
    }

    private static int runConsole(Center center, Arguments arguments, CenterSettings settings) throws Exception {
        try (Console console = Console.onStandardOutput()) {
            center.start(event -> console.emit(CenterEventPrinter.of(event)));
            console.ready(CenterEventPrinter.ready(center));
            Program.runConsole(console, arguments, new CenterCommands(center, console));
            return console.exitStatus();
        }
    }
}
