package simgsm.center;

import java.nio.file.Path;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.ui.Display;

/** Starts M3 from the command line. */
public final class CenterMain {
    private CenterMain() {}

    public static void main(String[] args) {
        new Program("simgsm-center", options()).runAndExit(args, CenterMain::run);
    }

    private static Options options() {
        return Program.commonOptions(
                        "java -jar simgsm-center.jar [OPTION]...",
                        "M3, the SMS/Phone centre: phones and modems register here, call each other and send messages.")
                .flag(
                        "demo",
                        "the whole suite: the centre, one phone and one SimRobot, ready to dial; without a display a"
                                + "\nscripted session whose transcript is printed")
                .value(
                        "port",
                        "N",
                        "TCP port for phones and modems, 0 for any free one; default " + CenterSettings.DEFAULT_PORT)
                .value("bind", "ADDRESS", "address to listen on; default loopback only")
                .value("data", "DIR", "where messages and subscribers are kept; one process at a time");
    }

    private static int run(Arguments arguments) throws Exception {
        CenterSettings settings = CenterSettings.read(arguments);
        boolean isHeadless = arguments.has("headless") || !Display.isThere();
        if (arguments.has("demo")) {
            return isHeadless ? HeadlessDemo.run(arguments, settings) : WindowedDemo.run(arguments, settings);
        }
        if (isHeadless && !arguments.has("headless")) {
            System.err.println(
                    "simgsm-center: " + Messages.in(settings.language()).of("error.noDisplay"));
            return ExitStatus.UNAVAILABLE;
        }
        Path data = settings.data().orElseGet(() -> DataDirectory.defaultPath(System.getenv(), System.getProperties()));
        try (Center center = Center.open(settings, data, settings.port().orElse(CenterSettings.DEFAULT_PORT))) {
            return isHeadless ? runConsole(center, arguments, settings) : CenterWindow.run(center, arguments, settings);
        }
    }

    private static int runConsole(Center center, Arguments arguments, CenterSettings settings) throws Exception {
        Console console = new Console(Program.standardOutput());
        try (EventPrinter printer = new EventPrinter(console)) {
            center.start(settings.seed(), printer);
            console.ready(Event.of("ready").with("port", center.port()));
            Program.runConsole(console, arguments, new CenterCommands(center, printer));
        }
        return console.exitStatus();
    }
}
