package simrobot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.audio.SoundCard;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.FatalError;
import simgsm.console.HostPort;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.modem.ModemOptions;
import simgsm.net.LineAddress;
import simgsm.sim.SimSlot;
import simgsm.speech.AudioOutput;
import simgsm.speech.SpeechCodec;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.StartErrorWindow;
import simgsm.ui.window.WindowMemory;
import simrobot.app.BatchRun;
import simrobot.app.CallRecordings;
import simrobot.app.HeadlessReplay;
import simrobot.app.ListeningPorts;
import simrobot.app.ModemCheckRun;
import simrobot.app.ReplayModel;
import simrobot.app.RequestedBehaviours;
import simrobot.app.RequestedRobots;
import simrobot.app.SessionRecording;
import simrobot.app.WindowModel;
import simrobot.app.WorldFile;
import simrobot.control.FileExports;
import simrobot.control.Fleet;
import simrobot.control.RobotConsole;
import simrobot.control.RobotName;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.control.WorldPrinter;
import simrobot.process.BehaviourKind;
import simrobot.replay.DamagedException;
import simrobot.replay.Recording;
import simrobot.replay.ReplayThread;
import simrobot.robot.Noise;
import simrobot.simulation.Simulation;
import simrobot.ui.floor.WorldPictures;
import simrobot.ui.panel.RefusalTexts;
import simrobot.ui.panel.SimRobotWindow;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** Starts SimRobot, with its window or on a console. */
public final class SimRobotMain {
    private static final String NAME = "simrobot";
    private static final HostPort DEFAULT_CENTER = new HostPort("127.0.0.1", 3003);
    private static final double MIN_SPEED = 0.001;
    private static final double MAX_SPEED = 1000;

    /** Options with which no window opens. */
    private static final String[] WINDOWLESS = {"headless", "run", "print-world", "modem-check"};

    private SimRobotMain() {}

    public static void main(String[] args) {
        new Program(NAME, options())
                .showingErrors(StartErrorWindow::show, WINDOWLESS)
                .runAndExit(args, SimRobotMain::run);
    }

    public static Options options() {
        return Program.commonOptions(
                        "java -jar simrobot.jar --number 5550200 --world worlds/office.map [options]",
                        "SimRobot: a simulated Pioneer with a GSM modem (M2), driven by telephone keys or SMS.")
                .commands(RobotConsole.COMMANDS)
                .flag("console", Program.CONSOLE_HELP)
                .value("number", "N", "the modem's number (5550200)")
                .collecting("robot", "NAME=NUMBER", "a robot with its own modem and number; repeat it for several")
                .value("robots", "all", "one robot on every RobotHome, numbers counting up from --number")
                .value(
                        "sim",
                        "FILE",
                        "the robots' SIMs, for a closed network: IMSI, number and key; each robot takes the one of"
                                + "\nits number")
                .value(
                        "world",
                        "FILE",
                        "the world: ARIA .map, Saphira .wld, ROS map.yaml with PGM or PNG, or PNG (worlds/demo.map)")
                .value("resolution", "METRES", "the width of a pixel of --world FILE.png")
                .value("center", "HOST:PORT", "the SMS/Phone centre (127.0.0.1:3003)")
                .value("codec", "alaw|gsm", "how the modem's speech is coded; it understands both (alaw)")
                .value(
                        "answer-after",
                        "MILLIS",
                        "how long the modem rings before it answers, 0 to 120000 (1500); 0: not at all")
                .value(
                        "record-audio",
                        "FILE.wav",
                        "record all calls in one file, left what the robot sends and right what it hears,"
                                + "\nwith 0.5 s of silence between calls; of several robots each in FILE-NAME.wav;"
                                + "\nan existing file is overwritten")
                .value("operators", "N,N,...", "the only numbers that may command; else every subscriber may")
                .value("on-hangup", "stop|finish", "what happens to a motion whose call is lost (stop)")
                .value("power", "on|off", "start with the robot switched on or off (on)")
                .value("motors", "on|off", "start with the motors switched on or off (on)")
                .value(
                        "behaviour",
                        "NAME",
                        "wander, wall-follow, one of --behaviours, or none: an autonomous process in every robot"
                                + "\n(none)")
                .value(
                        "behaviours",
                        "DIR",
                        "processes of your own: each .java file there, compiled whenever it is saved, and each jar;"
                                + "\nsee docs/BEHAVIOUR.md")
                .value(
                        "run",
                        "SECONDS",
                        "simulate that long as fast as the machine can, without centre and console, and end")
                .value("runs", "N", "with --run: N runs with seeds that count up, a line of CSV each")
                .value("track", "FILE.csv", "with --run: write pose and status of each robot every 0.1 s")
                .value(
                        "record",
                        "FILE",
                        "record the session: worlds, robots' states, events; an existing file is overwritten")
                .value(
                        "replay",
                        "FILE",
                        "replay a recorded session, in the window with a timeline; headless its events,"
                                + "\nat the pace of --speed or at once")
                .value("speed", "N", "simulated seconds per second (1)")
                .value(
                        "noise",
                        "N",
                        "errors of wheels and sonars: 0 none (the default), 1 as MobileSim's, at most 10;"
                                + "\nwith --seed they repeat")
                .value(
                        "at",
                        "PORT",
                        "take AT commands for the robots' modems, one port per robot upward from PORT; 0: any free ones")
                .value("p2os", "PORT", "serve P2OS clients, one port per robot upward from PORT; 0: any free ones")
                .value(
                        "pioneer",
                        "ADDRESS",
                        "drive a real Pioneer, or MobileSim, over P2OS in place of the simulated one:"
                                + "\nHOST:PORT, or a serial line's device file whose speed is set")
                .value(
                        "pioneer-params",
                        "FILE.p",
                        "the units of a real robot whose type is not built in: a params file of ARIA")
                .value(
                        "modem",
                        "ADDRESS",
                        "put a real modem in M2's place, which speaks AT commands: HOST:PORT, or a serial line's"
                                + "\ndevice file whose speed is set")
                .value(
                        "modem-check",
                        "ADDRESS",
                        "try a real modem command by command, print the answers, and end: 0 if it can serve as M2")
                .value(
                        "http",
                        "PORT",
                        "serve a page with map and cameras, status as JSON and pictures; 0: any free port")
                .value("bind", "ADDRESS", "address that AT, P2OS and HTTP ports listen on; default loopback only")
                .flag("print-world", "print what was loaded from the world file, in mm and degrees, and end");
    }

    private static int run(Arguments given) throws Exception {
        boolean hasWindow = Stream.of(WINDOWLESS).noneMatch(given::has);
        Arguments arguments = hasWindow ? WindowMemory.recall(given, "robot") : given;
        if (arguments.has("replay")) {
            return replay(arguments);
        }
        if (arguments.has("modem-check")) {
            return ModemCheckRun.run(
                    arguments.value("modem-check", LineAddress::parse).orElseThrow(), Program.standardOutput());
        }
        VeriCommandSettings settings = settings(arguments);
        World world = WorldFile.read(arguments.path("world"), WorldFile.resolution(arguments));
        if (arguments.has("print-world")) {
            WorldPrinter.print(world, Program.standardOutput());
            return ExitStatus.OK;
        }
        for (String option : List.of("runs", "track")) {
            if (arguments.has(option) && !arguments.has("run")) {
                throw new UsageException("--" + option + ": expected with --run SECONDS");
            }
        }
        if (arguments.has("run")) {
            return BatchRun.run(arguments, world);
        }
        // reads the rest of the command line: its errors come before that of a missing display
        Built built = build(arguments, settings, world);
        ListeningPorts ports = ListeningPorts.open(arguments, built.simRobot());
        return arguments.has("headless")
                ? headless(arguments, built, ports)
                : windowed(
                        arguments,
                        ProgramWindow.of(arguments, Optional.empty()),
                        built,
                        ports,
                        WorldFile.find(arguments.path("world")));
    }

    private static int replay(Arguments arguments)
            throws UsageException, UnavailableException, IOException, InterruptedException {
        double speed = arguments.number("speed", 1, MIN_SPEED, MAX_SPEED);
        Path file = arguments.path("replay").orElseThrow();
        if (!arguments.has("headless")) {
            return replayInWindow(ProgramWindow.of(arguments, Optional.empty()), arguments.language(), file, speed);
        }
        OptionalDouble pace = arguments.has("speed") ? OptionalDouble.of(speed) : OptionalDouble.empty();
        return new HeadlessReplay(Program.standardOutput(), System.err, pace).play(file);
    }

    private static ReplayThread opened(Path file) throws IOException {
        try {
            return new ReplayThread(Recording.open(file));
        } catch (DamagedException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
    }

    /** Replays in the window, from the beginning. */
    private static int replayInWindow(ProgramWindow window, Locale language, Path file, double speed)
            throws IOException, InterruptedException {
        try (ReplayThread replay = opened(file)) {
            ReplayModel model = new ReplayModel(replay, new RefusalTexts(language));
            replay.onFailure(fault -> FatalError.end(NAME, fault));
            replay.setSpeed(speed);
            replay.setPaused(false);
            replay.start();
            String title = "SimRobot - " + file.getFileName();
            window.show(chosen -> SimRobotWindow.content(title, chosen, model::snapshot, model));
        }
        return ExitStatus.OK;
    }

    private record Built(Simulation simulation, SimRobot simRobot, Fleet fleet, RequestedBehaviours behaviours) {}

    private static int windowed(
            Arguments arguments, ProgramWindow window, Built built, ListeningPorts opened, Path worldFile)
            throws UsageException, IOException, InterruptedException {
        Locale language = arguments.language();
        try (SessionRecording record = new SessionRecording(built.simRobot().simulation());
                SimRobot simRobot = built.simRobot();
                ListeningPorts ports = opened) {
            startRecording(record, arguments, built);
            endInOrder(simRobot, record);
            simRobot.onAdded(robot -> robot.listen(record.listener(robot.name())));
            Optional<Console> console =
                    arguments.has("console") ? Optional.of(Console.onStandardOutput()) : Optional.empty();
            console.ifPresent(out -> {
                simRobot.onAdded(robot -> robot.listen(event -> out.emit(event.line(robot.name()))));
                out.ready(ports.with(Event.of("ready").with("robots", names(simRobot))));
                window.onLesson(name -> out.emit(Event.of("lesson").with("name", name)));
            });
            WindowModel model = new WindowModel(simRobot, built.fleet(), ports, worldFile, new RefusalTexts(language));
            model.setResolution(WorldFile.resolution(arguments));
            simRobot.start();
            ports.start();
            built.behaviours().start(simRobot, record::event);
            if (console.isPresent()) {
                RobotConsole commands = commands(arguments, built, console.get()::emit);
                window.withConsole(() -> Program.runConsole(console.get(), arguments, commands));
            }
            String title = "SimRobot " + model.firstNumber();
            window.show(chosen -> SimRobotWindow.content(title, chosen, model::snapshot, model));
            console.ifPresent(Console::close);
        }
        return ExitStatus.OK;
    }

    private static Built build(Arguments arguments, VeriCommandSettings settings, World world)
            throws UsageException, IOException {
        HostPort center = arguments.hostPort("center").orElse(DEFAULT_CENTER);
        double speed = arguments.number("speed", 1, MIN_SPEED, MAX_SPEED);
        SimSlot slot = SimSlot.of(arguments.path("sim"));
        List<RobotName> names = RequestedRobots.of(arguments, slot, world);
        long seed = seed(arguments);
        Simulation simulation = new Simulation(world, seed);
        simulation.setStartInMiddle(arguments.has("robots"));
        RequestedBehaviours behaviours = RequestedBehaviours.of(arguments, simulation.behaviours());
        Fleet.Kit kit = kit(arguments, slot, names.size() == 1, seed, behaviours.chosen(arguments));
        simulation.setNoise(arguments.number("noise", 0, 0, Noise.MAX_SCALE));
        SimRobot simRobot = new SimRobot(
                simulation, new InetSocketAddress(center.host(), center.port()), settings, sound(arguments));
        simRobot.simulation().setSpeed(speed);
        simRobot.simulation().onFailure(fault -> FatalError.end(NAME, fault));
        Fleet fleet = new Fleet(simRobot, kit);
        Optional<LineAddress> real = RequestedRobots.real(arguments, names);
        Optional<LineAddress> modem = RequestedRobots.modem(arguments, names);
        if (real.isPresent()) {
            fleet.addReal(names.get(0), real.get(), RequestedRobots.parameters(arguments), simulation, modem);
        } else {
            for (RobotName name : names) {
                fleet.addFirst(name, simulation, modem);
            }
        }
        return new Built(simulation, simRobot, fleet, behaviours);
    }

    /** @param single whether there is one robot, whose calls are recorded in the named file itself */
    private static Fleet.Kit kit(Arguments arguments, SimSlot slot, boolean single, long seed, BehaviourKind behaviour)
            throws UsageException {
        boolean power = arguments.choice("power", "on", "off").equals("on");
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        CallRecordings recordings = new CallRecordings(arguments.path("record-audio"), single);
        return new Fleet.Kit(
                seed,
                power,
                motors,
                behaviour,
                codec(arguments),
                (int) arguments.integer(
                        "answer-after",
                        ModemOptions.DEFAULT_ANSWER_AFTER_MILLIS,
                        0,
                        ModemOptions.MAX_ANSWER_AFTER_MILLIS),
                recordings,
                number -> Arguments.checked(() -> slot.card(Optional.of(number))));
    }

    /** A window shows at once whether there is a device; a console opens it with the first sound. */
    private static AudioOutput sound(Arguments arguments) {
        if (arguments.has("no-sound")) {
            return AudioOutput.SILENT;
        }
        return arguments.has("headless") ? SoundCard.openWhenPlayed() : SoundCard.open();
    }

    private static SpeechCodec.Kind codec(Arguments arguments) throws UsageException {
        return arguments.choice("codec", "alaw", "gsm").equals("gsm")
                ? SpeechCodec.Kind.GSM_FULL_RATE
                : SpeechCodec.Kind.A_LAW;
    }

    public static long seed(Arguments arguments) throws UsageException {
        return arguments.has("seed")
                ? arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE)
                : new Random().nextLong();
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
            console.ready(ports.with(Event.of("ready").with("robots", names(simRobot))));
            simRobot.start();
            ports.start();
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

    public static VeriCommandSettings settings(Arguments arguments) throws UsageException {
        Set<String> operators =
                arguments.value("operators", SimRobotMain::operators).orElse(Set.of());
        VeriCommandSettings.OnHangup onHangup =
                arguments.choice("on-hangup", "stop", "finish").equals("stop")
                        ? VeriCommandSettings.OnHangup.STOP
                        : VeriCommandSettings.OnHangup.FINISH;
        return new VeriCommandSettings(arguments.language(), operators, onHangup);
    }

    private static Set<String> operators(String list) {
        Set<String> numbers = new HashSet<>();
        for (String number : list.split(",", -1)) {
            numbers.add(Msisdn.parse(number.strip()).digits());
        }
        return numbers;
    }
}
