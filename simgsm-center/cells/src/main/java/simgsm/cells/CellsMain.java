package simgsm.cells;

import java.util.Optional;
import simgsm.cells.app.CellsCommands;
import simgsm.cells.app.CellsEvents;
import simgsm.cells.app.CellsSettings;
import simgsm.cells.app.CellsWindow;
import simgsm.cells.app.ReportFile;
import simgsm.cells.net.CellsLoop;
import simgsm.cells.net.GsmtapSocket;
import simgsm.cells.network.CellNetwork;
import simgsm.cells.tower.AirInterface;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.FatalError;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.StartErrorWindow;
import simgsm.ui.window.WindowMemory;
import simgsm.ui.window.WindowOptions;

/** Starts the cells program from the command line. */
public final class CellsMain {
    private CellsMain() {}

    public static void main(String[] args) {
        new Program(CellsSettings.PROGRAM, options())
                .showingErrors(StartErrorWindow::show, "headless", "print-osmo-bsc")
                .checking(WindowOptions::check)
                .runAndExit(args, CellsMain::run);
    }

    private static Options options() {
        return Options.read(CellsMain.class.getResourceAsStream("options.txt")).commands(CellsCommands.COMMANDS);
    }

    private static int run(Arguments given) throws Exception {
        Arguments arguments = given.has("print-osmo-bsc") ? given : WindowMemory.recall(given, "cells");
        CellsSettings settings = CellsSettings.read(arguments);
        if (arguments.has("print-osmo-bsc")) {
            return settings.printOsmoBsc(Program.standardOutput());
        }
        Optional<ProgramWindow> window = arguments.has("headless")
                ? Optional.empty()
                : Optional.of(ProgramWindow.of(arguments, Optional.empty()));
        FatalError.endOnMachineErrors(CellsSettings.PROGRAM);
        try (Console console = Console.onStandardOutput()) {
            CellsEvents events = new CellsEvents(console);
            boolean prints = window.isEmpty() || arguments.has("console");
            GsmtapSocket capture = GsmtapSocket.to(settings.gsmtap());
            ReportFile reports = ReportFile.to(settings.reports());
            CellNetwork network = network(settings, capture, events, prints, reports);
            try (capture;
                    reports;
                    CellsLoop loop = new CellsLoop(network, settings.address(), settings.port())) {
                loop.start(settings.controllerAddress(), cause -> FatalError.end(CellsSettings.PROGRAM, cause));
                settings.followed()
                        .forEach(robot -> robot.start(place -> loop.post(cells -> cells.place(robot.number(), place))));
                CellsCommands commands = new CellsCommands(loop, console, events);
                if (prints) {
                    console.ready(Event.of("ready")
                            .with("port", loop.port())
                            .with("cells", settings.town().towers().size()));
                }
                if (window.isPresent()) {
                    if (prints) {
                        window.get().withConsole(console, arguments, commands);
                    }
                    return CellsWindow.run(loop, settings, window.get());
                }
                Program.runConsole(console, arguments, commands);
                return console.exitStatus();
            }
        }
    }

    private static CellNetwork network(
            CellsSettings settings, GsmtapSocket capture, CellsEvents events, boolean prints, ReportFile reports) {
        AirInterface air = new AirInterface(settings.algorithms(), capture);
        CellNetwork network =
                new CellNetwork(settings.town(), settings.seed(), air, prints ? reports.andThen(events) : reports);
        network.setHandoverRule(settings.handover());
        if (prints) {
            network.setOnRefusal(events::refused);
        }
        return network;
    }
}
