package simgsm.center;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.Random;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UsageException;

/** Starts M3 from the command line. */
public final class CenterMain {
    static final int DEFAULT_PORT = 3003;
    private static final int MAX_PORT = 0xffff;
    private static final System.Logger LOG = System.getLogger(CenterMain.class.getName());

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
                .value("port", "N", "TCP port for phones and modems, 0 for any free one; default " + DEFAULT_PORT)
                .value("bind", "ADDRESS", "address to listen on; default loopback only")
                .value("data", "DIR", "where messages and subscribers are kept; one process at a time");
    }

    private static int run(Arguments arguments) throws Exception {
        boolean isHeadless = arguments.has("headless") || GraphicsEnvironment.isHeadless();
        int port = port(arguments, DEFAULT_PORT);
        if (arguments.has("demo")) {
            return isHeadless ? HeadlessDemo.run(arguments) : WindowedDemo.run(arguments);
        }
        if (isHeadless && !arguments.has("headless")) {
            System.err.println(
                    "simgsm-center: " + Messages.in(arguments.language()).of("error.noDisplay"));
            return ExitStatus.UNAVAILABLE;
        }
        try (Center center = open(arguments, dataDirectory(arguments), port)) {
            return isHeadless ? runConsole(center, arguments) : CenterWindow.run(center, arguments);
        }
    }

    private static int runConsole(Center center, Arguments arguments) throws Exception {
        Console console = new Console(Program.standardOutput());
        try (EventPrinter printer = new EventPrinter(console)) {
            center.start(seed(arguments), printer);
            console.ready(Event.of("ready").with("port", center.port()));
            Program.runConsole(console, arguments, new CenterCommands(center, printer));
        }
        return console.exitStatus();
    }

    static Center open(Arguments arguments, Path data, int port) throws IOException, UsageException {
        InetAddress address = arguments.value("bind", CenterMain::address).orElse(InetAddress.getLoopbackAddress());
        if (!address.isLoopbackAddress()) {
            LOG.log(
                    Level.WARNING,
                    "listening on {0}: whoever reaches this address may register under any number",
                    address.getHostAddress());
        }
        return Center.open(DataDirectory.take(data), address, port);
    }

    static int port(Arguments arguments, int otherwise) throws UsageException {
        return (int) arguments.integer("port", otherwise, 0, MAX_PORT);
    }

    static long seed(Arguments arguments) throws UsageException {
        return arguments.has("seed")
                ? arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE)
                : new Random().nextLong();
    }

    private static Path dataDirectory(Arguments arguments) throws UsageException {
        return arguments
                .path("data")
                .orElseGet(() -> DataDirectory.defaultPath(System.getenv(), System.getProperties()));
    }

    private static InetAddress address(String text) {
        try {
            return InetAddress.getByName(text);
        } catch (UnknownHostException e) {
            throw new IllegalArgumentException("expected an address of this machine, found " + text);
        }
    }
}
