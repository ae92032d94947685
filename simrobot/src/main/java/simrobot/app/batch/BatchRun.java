package simrobot.app.batch;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.sim.SimSlot;
import simrobot.app.RequestedBehaviours;
import simrobot.app.RequestedRobots;
import simrobot.app.SimRobotOptions;
import simrobot.control.RobotEvent;
import simrobot.control.RobotName;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.replay.SessionRecorder;
import simrobot.robot.Noise;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/**
 * {@code --run SECONDS}: simulates that time at full speed on the main thread alone, without centre, modem or console,
 * by the same simulation as windows and consoles. {@code --runs N} repeats it with N seeds.
 */
public final class BatchRun {
    private static final double MAX_SECONDS = 1e9;
    private static final long MAX_RUNS = 1_000_000;

    /** Options that need real time or a peer. */
    private static final List<String> LIVE_OPTIONS = List.of("pioneer", "http", "p2os", "at", "modem");

    private final Arguments arguments;
    private final RequestedBehaviours behaviours;
    private final World world;
    private final List<String> names;
    private final long seed;
    private final double seconds;

    private BatchRun(Arguments arguments, RequestedBehaviours behaviours, World world)
            throws UsageException, IOException {
        this.arguments = arguments;
        this.behaviours = behaviours;
        this.world = world;
        names = RequestedRobots.of(arguments, SimSlot.of(arguments.path("sim")), world).stream()
                .map(RobotName::name)
                .toList();
        seed = SimRobotOptions.seed(arguments);
        seconds = arguments.number("run", 0, 0.001, MAX_SECONDS);
    }

    public static int run(Arguments arguments, World world) throws UsageException, IOException {
        refuse(arguments, LIVE_OPTIONS, ": a run (--run) has no clients, expected one of the two");
        try (RequestedBehaviours behaviours = RequestedBehaviours.of(arguments, new BehaviourList())) {
            BatchRun batch = new BatchRun(arguments, behaviours, world);
            return arguments.has("runs") ? batch.runAll() : batch.runOne();
        }
    }

    private static void refuse(Arguments arguments, List<String> options, String why) throws UsageException {
        for (String option : options) {
            if (arguments.has(option)) {
                throw new UsageException("--" + option + why);
            }
        }
    }

    /** One run, with its files. */
    private int runOne() throws UsageException, IOException {
        long began = System.nanoTime();
        Simulation simulation = simulation(seed);
        try {
            record(simulation);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            endAll(simulation);
        }
        double wall = (System.nanoTime() - began) * 1e-9;
        Program.standardOutput()
                .println(Event.of("ran")
                        .with("robots", names.size())
                        .with("simulated", threeDecimals(seconds))
                        .with("cpu", threeDecimals(cpuSeconds()))
                        .with("wall", threeDecimals(wall)));
        return ExitStatus.OK;
    }

    private void record(Simulation simulation) throws UsageException, IOException {
        Optional<Path> record = arguments.path("record");
        // without a thread for it, the recorder writes whenever its buffer is full
        try (SessionRecorder recorder =
                record.isPresent() ? SessionRecorder.open(record.get(), simulation, act -> {}) : null) {
            if (recorder != null) {
                simulation.robots().forEach(robot -> record(robot, recorder));
            }
            begin(simulation);
            track(simulation);
            if (recorder != null) {
                recorder.finish();
            }
        }
    }

    private void track(Simulation simulation) throws IOException, UsageException {
        Optional<Path> track = arguments.path("track");
        RunTrack written = track.isPresent() ? new RunTrack(track.get(), simulation) : null;
        try {
            simulate(simulation);
        } finally {
            if (written != null) {
                written.close();
            }
        }
    }

    /** {@code --runs N}: a line of CSV for each of N seeds, counting up. */
    private int runAll() throws UsageException, IOException {
        refuse(arguments, List.of("record", "track"), ": a file holds one run, expected no --runs beside it");
        long runs = arguments.integer("runs", 1, 1, MAX_RUNS);
        PrintStream out = Program.standardOutput();
        out.println(RunTally.HEADER);
        for (long run = seed; run < seed + runs; run++) {
            Simulation simulation = simulation(run);
            RunTally tally = new RunTally(simulation);
            try {
                begin(simulation);
                simulate(simulation);
            } finally {
                endAll(simulation);
            }
            out.println(tally.line(run, seconds));
        }
        return ExitStatus.OK;
    }

    private Simulation simulation(long ofRun) throws UsageException {
        Simulation simulation = new Simulation(world, ofRun);
        simulation.setStartInMiddle(arguments.has("robots"));
        simulation.setNoise(arguments.number("noise", 0, 0, Noise.MAX_SCALE));
        simulation.setTrails(false);
        simulation.addRobots(names);
        return simulation;
    }

    /** Ends processes, which may have threads. */
    private static void endAll(Simulation simulation) {
        simulation.robots().forEach(robot -> robot.autonomy().end());
    }

    private void begin(Simulation simulation) throws UsageException {
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        boolean power = arguments.choice("power", "on", "off").equals("on");
        BehaviourKind behaviour = behaviours.chosenForRun(arguments, simulation.behaviours());
        for (SimulatedRobot robot : simulation.robots()) {
            robot.setMotors(motors);
            robot.setPower(power);
            robot.autonomy().begin(behaviour);
        }
    }

    private void simulate(Simulation simulation) {
        for (long left = Math.round(seconds * 1e9 / Simulation.STEP_NANOS); left > 0; left--) {
            simulation.step();
        }
    }

    private static void record(SimulatedRobot robot, SessionRecorder recorder) {
        robot.addStatusListener(status -> recorder.event(new RobotEvent.StatusChanged(status).line(robot.name())));
        robot.autonomy().addListener(kind -> recorder.event(new RobotEvent.BehaviourChanged(kind).line(robot.name())));
    }

    /** CPU time of the whole process since its start, user and system. */
    private static double cpuSeconds() {
        return ProcessHandle.current()
                        .info()
                        .totalCpuDuration()
                        .orElse(Duration.ZERO)
                        .toNanos()
                * 1e-9;
    }

    private static String threeDecimals(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
