package simgsm.cells;

import simgsm.cells.app.CellsCommands;
import simgsm.cells.app.CellsEvents;
import simgsm.cells.app.CellsSettings;
import simgsm.cells.net.CellsLoop;
import simgsm.cells.network.CellNetwork;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.FatalError;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UnavailableException;

/** Starts the cells program from the command line. */
public final class CellsMain {
    private CellsMain() {}

    public static void main(String[] args) {
        new Program(CellsSettings.PROGRAM, options()).runAndExit(args, CellsMain::run);
    }

    private static Options options() {
        return Program.commonOptions(
                        "java -jar simgsm-cells.jar --town FILE.town [OPTION]...",
                        "The cells of a town: towers between phones and robots, which connect here, and a controller.")
                .commands(CellsCommands.COMMANDS)
                .value("town", "FILE", "town file with the towers; needed")
                .value("center", "HOST:PORT", "the controller: centre or osmo-bsc; default 127.0.0.1:3003")
                .value(
                        "controller",
                        "ours|osmo-bsc",
                        "ours (default): a centre of this suite; osmo-bsc: a base station controller of Osmocom")
                .value(
                        "port",
                        "N",
                        "TCP port for phones and modems, 0 for any free one; default " + CellsSettings.DEFAULT_PORT)
                .value("bind", "ADDRESS", "address to listen on; default loopback only")
                .flag("print-osmo-bsc", "print the configuration of osmo-bsc for the town's towers, and end");
    }

    private static int run(Arguments arguments) throws Exception {
        CellsSettings settings = CellsSettings.read(arguments);
        if (arguments.has("print-osmo-bsc")) {
            return settings.printOsmoBsc(Program.standardOutput());
        }
        if (!arguments.has("headless")) {
            throw new UnavailableException("the window is not there yet; use --headless");
        }
        try (Console console = Console.onStandardOutput()) {
            CellsEvents events = new CellsEvents(console);
            CellNetwork network = new CellNetwork(settings.town(), settings.seed(), events);
            try (CellsLoop loop = new CellsLoop(network, settings.address(), settings.port())) {
                FatalError.endOnMachineErrors(CellsSettings.PROGRAM);
                loop.start(settings.controllerAddress(), cause -> FatalError.end(CellsSettings.PROGRAM, cause));
                console.ready(Event.of("ready")
                        .with("port", loop.port())
                        .with("cells", settings.town().towers().size()));
                Program.runConsole(console, arguments, new CellsCommands(loop, console, events));
                return console.exitStatus();
            }
        }
    }
}
