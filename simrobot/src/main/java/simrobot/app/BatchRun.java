package simrobot.app;

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
 * {@code --run SECONDS}: simulates that long, as fast as the machine can, on the main thread alone: no centre, no modem, no
 * console. The simulation is the one that windows and consoles use. {@code --runs N} does so for N seeds.
 */
public final class BatchRun {
    private static final double MAX_SECONDS = 1e9;
    private static final long MAX_RUNS = 1_000_000;

    /** Options that need real time or a peer. */
    private static final List<String> LIVE_OPTIONS = List.of("pioneer", "http", "p2os", "at", "modem");

    private BatchRun() {}

    public static int run(Arguments arguments, World world) throws UsageException, IOException {
        for (String live : LIVE_OPTIONS) {
            if (arguments.has(live)) {
                throw new UsageException("--" + live + ": a run (--run) has no clients, expected one of the two");
            }
        }
        List<String> names = RequestedRobots.of(arguments, SimSlot.of(arguments.path("sim")), world).stream()
                .map(RobotName::name)
                .toList();
        long seed = SimRobotOptions.seed(arguments);
        double seconds = arguments.number("run", 0, 0.001, MAX_SECONDS);
        try (RequestedBehaviours behaviours = RequestedBehaviours.of(arguments, new BehaviourList())) {
            return arguments.has("runs")
                    ? runAll(arguments, behaviours, world, names, seed, seconds)
                    : runOne(arguments, behaviours, world, names, seed, seconds);
        }
    }

    /** One run, with its files. */
    private static int runOne(
            Arguments arguments,
            RequestedBehaviours behaviours,
            World world,
            List<String> names,
            long seed,
            double seconds)
            throws UsageException, IOException {
        Optional<Path> record = arguments.path("record");
        Optional<Path> track = arguments.path("track");
        long began = System.nanoTime();
        Simulation simulation = simulation(arguments, world, names, seed);
        // without a thread that performs acts, records are written when they are full
        try (SessionRecorder recorder =
                record.isPresent() ? SessionRecorder.open(record.get(), simulation, act -> {}) : null) {
            if (recorder != null) {
                simulation.robots().forEach(robot -> record(robot, recorder));
            }
            begin(arguments, behaviours, simulation);
            RunTrack written = track.isPresent() ? new RunTrack(track.get(), simulation) : null;
            try {
                simulate(simulation, seconds);
            } finally {
                if (written != null) {
                    written.close();
                }
            }
            if (recorder != null) {
                recorder.finish();
            }
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

    /** {@code --runs N}: a line of CSV for each of N seeds, counting up. */
    private static int runAll(
            Arguments arguments,
            RequestedBehaviours behaviours,
            World world,
            List<String> names,
            long seed,
            double seconds)
            throws UsageException, IOException {
        for (String file : List.of("record", "track")) {
            if (arguments.has(file)) {
                throw new UsageException("--" + file + ": a file holds one run, expected no --runs beside it");
            }
        }
        long runs = arguments.integer("runs", 1, 1, MAX_RUNS);
        PrintStream out = Program.standardOutput();
        out.println(RunTally.HEADER);
        for (long run = seed; run < seed + runs; run++) {
            Simulation simulation = simulation(arguments, world, names, run);
            RunTally tally = new RunTally(simulation);
            try {
                begin(arguments, behaviours, simulation);
                simulate(simulation, seconds);
            } finally {
                endAll(simulation);
            }
            out.println(tally.line(run, seconds));
        }
        return ExitStatus.OK;
    }

    private static Simulation simulation(Arguments arguments, World world, List<String> names, long seed)
            throws UsageException {
        Simulation simulation = new Simulation(world, seed);
        simulation.setStartInMiddle(arguments.has("robots"));
        simulation.setNoise(arguments.number("noise", 0, 0, Noise.MAX_SCALE));
        simulation.setTrails(false);
        simulation.addRobots(names);
        return simulation;
    }

    /** A process may have a thread, which ends with it. */
    private static void endAll(Simulation simulation) {
        simulation.robots().forEach(robot -> robot.autonomy().end());
    }

    private static void begin(Arguments arguments, RequestedBehaviours behaviours, Simulation simulation)
            throws UsageException {
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        boolean power = arguments.choice("power", "on", "off").equals("on");
        BehaviourKind behaviour = behaviours.chosenForRun(arguments, simulation.behaviours());
        for (SimulatedRobot robot : simulation.robots()) {
            robot.setMotors(motors);
            robot.setPower(power);
            robot.autonomy().begin(behaviour);
        }
    }

    private static void simulate(Simulation simulation, double seconds) {
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
