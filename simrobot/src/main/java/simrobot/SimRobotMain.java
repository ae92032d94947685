package simrobot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.FatalError;
import simgsm.console.HostPort;
import simgsm.console.Program;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.net.LineAddress;
import simgsm.sim.SimSlot;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.StartErrorWindow;
import simgsm.ui.window.WindowMemory;
import simgsm.ui.window.WindowOptions;
import simrobot.app.RequestedBehaviours;
import simrobot.app.RequestedRobots;
import simrobot.app.SessionRecording;
import simrobot.app.SimRobotOptions;
import simrobot.app.WorldFile;
import simrobot.app.batch.BatchRun;
import simrobot.app.batch.GradeRun;
import simrobot.app.batch.HeadlessReplay;
import simrobot.app.batch.ModemCheckRun;
import simrobot.app.ports.ListeningPorts;
import simrobot.app.window.RecentWorlds;
import simrobot.app.window.ReplayModel;
import simrobot.app.window.SessionModel;
import simrobot.app.window.WindowModel;
import simrobot.control.FileExports;
import simrobot.control.Fleet;
import simrobot.control.RealModem;
import simrobot.control.RobotConsole;
import simrobot.control.RobotName;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.control.WorldPrinter;
import simrobot.replay.DamagedException;
import simrobot.replay.Recording;
import simrobot.replay.ReplayThread;
import simrobot.robot.Noise;
import simrobot.simulation.Simulation;
import simrobot.ui.floor.WorldPictures;
import simrobot.ui.inspector.RefusalTexts;
import simrobot.ui.panel.SimRobotWindow;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** Starts SimRobot, with its window or on a console. */
public final class SimRobotMain {
    private static final String NAME = "simrobot";
    private static final HostPort DEFAULT_CENTER = new HostPort("127.0.0.1", 3003);

    /** Options that open no window. */
    private static final String[] WINDOWLESS = {"headless", "run", "grade", "print-world", "modem-check"};

    private SimRobotMain() {}

    public static void main(String[] args) {
        new Program(NAME, SimRobotOptions.all())
                .showingErrors(StartErrorWindow::show, WINDOWLESS)
                .checking(WindowOptions::check)
                .runAndExit(args, SimRobotMain::run);
    }

    private static int run(Arguments given) throws Exception {
        boolean hasWindow = Stream.of(WINDOWLESS).noneMatch(given::has);
        Arguments arguments = hasWindow ? WindowMemory.recall(given, "robot") : given;
        if (arguments.has("replay-from") && (!arguments.has("replay") || !hasWindow)) {
            throw new UsageException("--replay-from: expected with --replay FILE, in a window");
        }
        if (arguments.has("replay")) {
            return replay(arguments);
        }
        if (arguments.has("modem-check")) {
            return ModemCheckRun.run(
                    arguments.value("modem-check", LineAddress::parse).orElseThrow(), Program.standardOutput());
        }
        VeriCommandSettings settings = SimRobotOptions.settings(arguments);
        RecentWorlds recent = RecentWorlds.of(arguments);
        RecentWorlds.Start start = recent.start(given);
        Optional<Path> first = start.file();
        for (String output : List.of("record", "track")) {
            arguments.with("world", WorldFile.find(first).toString()).requireOtherFile(output, "world");
        }
        World world = start.world();
        if (arguments.has("print-world")) {
            WorldPrinter.print(world, Program.standardOutput());
            return ExitStatus.OK;
        }
        if (arguments.has("grade")) {
            return GradeRun.run(arguments, world);
        }
        for (String option : List.of("runs", "track", "goal", "limit")) {
            if (arguments.has(option) && !arguments.has("run")) {
                throw new UsageException("--" + option + ": expected with --run SECONDS");
            }
        }
        if (arguments.has("run")) {
            return BatchRun.run(arguments, world);
        }
        // reads the rest of the command line first, so that its errors precede that of a missing display
        Built built = build(arguments, settings, world);
        ListeningPorts ports = ListeningPorts.open(arguments, built.simRobot());
        return arguments.has("headless")
                ? headless(arguments, built, ports)
                : windowed(arguments, built, ports, WorldFile.find(first), recent);
    }

    private static int replay(Arguments arguments)
            throws UsageException, UnavailableException, IOException, InterruptedException {
        double speed = SimRobotOptions.speed(arguments);
        Path file = arguments.path("replay").orElseThrow();
        if (!arguments.has("headless")) {
            return replayInWindow(arguments, ProgramWindow.of(arguments, Optional.empty()), file, speed);
        }
        OptionalDouble pace = speed > 0 && arguments.has("speed") ? OptionalDouble.of(speed) : OptionalDouble.empty();
        return new HeadlessReplay(Program.standardOutput(), System.err, pace).play(file);
    }

    private static ReplayThread opened(Path file) throws IOException {
        try {
            return new ReplayThread(Recording.open(file));
        } catch (DamagedException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
    }

    /** Replays in the window, from the beginning or from the time in the arguments. */
    private static int replayInWindow(Arguments arguments, ProgramWindow window, Path file, double speed)
            throws UsageException, IOException, InterruptedException {
        long from = arguments.integer("replay-from", 0, 0, Integer.MAX_VALUE);
        try (ReplayThread replay = opened(file)) {
            RefusalTexts refusals = new RefusalTexts(arguments.language());
            ReplayModel model = new ReplayModel(replay, refusals);
            replay.seek(replay.recording().firstNanos() + TimeUnit.SECONDS.toNanos(from));
            replay.onFailure(fault -> FatalError.end(NAME, fault));
            replay.setSpeed(speed == 0 ? 1 : speed);
            replay.setPaused(speed == 0);
            replay.start();
            show(window, refusals, "SimRobot - " + file.getFileName(), model);
        }
        return ExitStatus.OK;
    }

    private static void show(ProgramWindow window, RefusalTexts refusals, String title, SessionModel model)
            throws InterruptedException {
        window.show(chosen -> {
            refusals.speak(chosen);
            return SimRobotWindow.content(title, chosen, model::snapshot, model);
        });
        model.close();
    }

    private record Built(Simulation simulation, SimRobot simRobot, Fleet fleet, RequestedBehaviours behaviours) {}

    private static int windowed(
            Arguments arguments, Built built, ListeningPorts opened, Path worldFile, RecentWorlds recent)
            throws UsageException, UnavailableException, IOException, InterruptedException {
        ProgramWindow window = ProgramWindow.of(arguments, Optional.empty());
        try (SessionRecording record = new SessionRecording(built.simRobot().simulation());
                SimRobot simRobot = built.simRobot();
                ListeningPorts ports = opened) {
            startRecording(record, arguments, built);
            endInOrder(simRobot, record);
            simRobot.onAdded(robot -> robot.listen(record.listener(robot.name())));
            Optional<Console> console =
                    arguments.has("console") ? Optional.of(Console.onStandardOutput()) : Optional.empty();
            console.ifPresent(out ->
                    simRobot.onAdded(robot -> robot.listen(event -> out.emit(event.line(robot.name())))));
            RefusalTexts refusals = new RefusalTexts(arguments.language());
            WindowModel model = new WindowModel(simRobot, built.fleet(), ports, worldFile, recent, refusals);
            model.setResolution(WorldFile.resolution(arguments));
            model.watch(record);
            simRobot.start();
            ports.start();
            console.ifPresent(out -> out.ready(ports.with(Event.of("ready").with("robots", names(simRobot)))));
            built.behaviours().start(simRobot, event -> {
                record.event(event);
                console.ifPresent(printed -> printed.emit(event));
            });
            if (console.isPresent()) {
                window.withConsole(console.get(), arguments, commands(arguments, built, console.get()::emit));
            }
            show(window, refusals, model.title(), model);
            console.ifPresent(Console::close);
        }
        return ExitStatus.OK;
    }

    private static Built build(Arguments arguments, VeriCommandSettings settings, World world)
            throws UsageException, IOException {
        HostPort center = arguments.hostPort("center").orElse(DEFAULT_CENTER);
        double speed = SimRobotOptions.speed(arguments);
        SimSlot slot = SimSlot.of(arguments.path("sim"));
        List<RobotName> names = RequestedRobots.of(arguments, slot, world);
        long seed = SimRobotOptions.seed(arguments);
        Simulation simulation = new Simulation(world, seed);
        simulation.setStartInMiddle(arguments.has("robots"));
        RequestedBehaviours behaviours = RequestedBehaviours.of(arguments, simulation.behaviours());
        Fleet.Kit kit = SimRobotOptions.kit(arguments, slot, names.size() == 1, seed, behaviours.chosen(arguments));
        simulation.setNoise(arguments.number("noise", 0, 0, Noise.MAX_SCALE));
        SimRobot simRobot = new SimRobot(
                simulation,
                new InetSocketAddress(center.host(), center.port()),
                settings,
                SimRobotOptions.sound(arguments));
        simRobot.simulation().setPaused(speed == 0);
        simRobot.simulation().setSpeed(speed == 0 ? 1 : speed);
        simRobot.simulation().onFailure(fault -> FatalError.end(NAME, fault));
        Fleet fleet = new Fleet(simRobot, kit);
        Optional<LineAddress> real = RequestedRobots.real(arguments, names);
        Optional<RealModem> modem = RequestedRobots.modem(arguments, names);
        if (real.isPresent()) {
            fleet.addReal(names.get(0), real.get(), RequestedRobots.parameters(arguments), simulation, modem);
        } else {
            for (RobotName name : names) {
                fleet.addFirst(name, simulation, modem);
            }
        }
        return new Built(simulation, simRobot, fleet, behaviours);
    }

    private static int headless(Arguments arguments, Built built, ListeningPorts opened)
            throws UsageException, IOException, InterruptedException {
        try (Console console = Console.onStandardOutput();
                SessionRecording record = new SessionRecording(built.simRobot().simulation());
                SimRobot simRobot = built.simRobot();
                ListeningPorts ports = opened) {
            Consumer<Event> out = ((Consumer<Event>) console::emit).andThen(record::event);
            simRobot.onAdded(robot -> robot.listen(event -> out.accept(event.line(robot.name()))));
            startRecording(record, arguments, built);
            endInOrder(simRobot, record);
            simRobot.start();
            ports.start();
            console.ready(ports.with(Event.of("ready").with("robots", names(simRobot))));
            built.behaviours().start(simRobot, out);
            Program.runConsole(console, arguments, commands(arguments, built, out));
            return console.exitStatus();
        }
    }

    private static RobotConsole commands(Arguments arguments, Built built, Consumer<Event> out) throws UsageException {
        OptionalDouble resolution = WorldFile.resolution(arguments);
        SimRobot simRobot = built.simRobot();
        return new RobotConsole(
                simRobot,
                built.fleet(),
                new FileExports(simRobot.tracks()::csv, new WorldPictures()),
                file -> WorldFile.read(Optional.of(file), resolution),
                out);
    }

    private static void startRecording(SessionRecording record, Arguments arguments, Built built)
            throws UsageException, IOException {
        Optional<Path> file = arguments.path("record");
        if (file.isPresent()) {
            record.start(file.get(), built.simulation());
        }
    }

    /** Detaches the modems and completes the recording when a signal ends the program. */
    private static void endInOrder(SimRobot simRobot, SessionRecording record) {
        Thread end = new Thread(
                () -> {
                    simRobot.close();
                    record.close();
                },
                "detach");
        Runtime.getRuntime().addShutdownHook(end);
    }

    private static String names(SimRobot simRobot) {
        return simRobot.robots().stream().map(TelephoneRobot::name).collect(Collectors.joining(","));
    }
}
