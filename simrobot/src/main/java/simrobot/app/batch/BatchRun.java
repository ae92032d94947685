package simrobot.app.batch;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
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
import simrobot.behaviour.BehaviourRequest;
import simrobot.control.RobotEvent;
import simrobot.control.RobotName;
import simrobot.process.BehaviourList;
import simrobot.process.Decision;
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
    /** The system property of a run that a grader has started: it must not outlive that. */
    static final String ENDS_WITH_PARENT = "simrobot.endsWithParent";

    private static final double MAX_SECONDS = 1e9;
    private static final long MAX_RUNS = 1_000_000;

    /** The bound of {@code --run done}, in simulated seconds. */
    private static final double DEFAULT_LIMIT_SECONDS = 600;

    /** Options that need real time or a peer. */
    private static final List<String> LIVE_OPTIONS = List.of("pioneer", "http", "p2os", "at", "modem");

    private final Arguments arguments;
    private final RequestedBehaviours behaviours;
    private final World world;
    private final List<String> names;
    private final Optional<RunGoal> goal;
    private final long seed;
    private final boolean isUntilDone;
    private final double seconds;
    private volatile RunJudge judge;

    private BatchRun(Arguments arguments, RequestedBehaviours behaviours, World world)
            throws UsageException, IOException {
        this.arguments = arguments;
        this.behaviours = behaviours;
        this.world = world;
        names = RequestedRobots.of(arguments, SimSlot.of(arguments.path("sim")), world).stream()
                .map(RobotName::name)
                .toList();
        seed = SimRobotOptions.seed(arguments);
        goal = arguments.value("goal", name -> RunGoal.named(world, name));
        isUntilDone = arguments.text("run").orElseThrow().equals("done");
        if (isUntilDone ? !arguments.has("behaviour") : arguments.has("limit")) {
            throw new UsageException(
                    isUntilDone ? "--run done: expected --behaviour NAME" : "--limit: expected with --run done");
        }
        seconds = isUntilDone
                ? arguments.number("limit", DEFAULT_LIMIT_SECONDS, 0.001, MAX_SECONDS)
                : arguments.number("run", 0, 0.001, MAX_SECONDS);
    }

    public static int run(Arguments arguments, World world) throws UsageException, IOException {
        if (Boolean.getBoolean(ENDS_WITH_PARENT)) {
            ProcessHandle.current()
                    .parent()
                    .ifPresent(parent ->
                            parent.onExit().thenRun(() -> Runtime.getRuntime().halt(1)));
        }
        refuse(arguments, LIVE_OPTIONS, ": a run (--run) has no clients, expected one of the two");
        try (RequestedBehaviours behaviours = RequestedBehaviours.of(arguments, new BehaviourList())) {
            BatchRun batch = new BatchRun(arguments, behaviours, world);
            if (arguments.has("runs")) {
                // a file in this program could write rows of its own
                behaviours.waitForDecisions();
                return batch.runAll();
            }
            behaviours.callDirectly(batch::broken);
            return batch.runOne();
        }
    }

    /** @throws UsageException if a run cannot have these options in this world */
    static void check(Arguments arguments, World world) throws UsageException, IOException {
        refuse(arguments, LIVE_OPTIONS, ": a run (--run, --grade) has no clients, expected one of the two");
        try (RequestedBehaviours none = RequestedBehaviours.of(arguments.without("behaviours"), new BehaviourList())) {
            new BatchRun(arguments, none, world);
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
        RunJudge judge = judge(simulation);
        PrintStream out = Program.standardOutput();
        simulation.robots().forEach(robot -> print(robot, out));
        try {
            record(simulation, judge);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            endAll(simulation);
        }
        double wall = (System.nanoTime() - began) * 1e-9;
        out.println(Event.of("ran")
                .with("robots", names.size())
                .with("simulated", RunOutcome.threeDecimals(simulation.timeNanos() * 1e-9))
                .with("cpu", RunOutcome.threeDecimals(cpuSeconds()))
                .with("wall", RunOutcome.threeDecimals(wall)));
        judge.outcomes().forEach(outcome -> out.println(outcome.event()));
        return judge.isAllDone() ? ExitStatus.OK : ExitStatus.FAILED;
    }

    /** Prints what the robot's process prints. */
    private static void print(SimulatedRobot robot, PrintStream out) {
        robot.autonomy().addRequestListener((kind, asked) -> {
            if (asked instanceof BehaviourRequest.Printed printed) {
                printed.text()
                        .lines()
                        .forEach(line -> out.println(new RobotEvent.Printed(kind.text(), line).line(robot.name())));
            }
        });
    }

    private void record(Simulation simulation, RunJudge judge) throws UsageException, IOException {
        Optional<Path> record = arguments.path("record");
        Optional<Path> track = arguments.path("track");
        // without a thread for it, the recorder writes whenever its buffer is full
        try (SessionRecorder recorder =
                record.isPresent() ? SessionRecorder.open(record.get(), simulation, act -> {}) : null) {
            if (recorder != null) {
                simulation.robots().forEach(robot -> record(robot, recorder));
            }
            begin(simulation, judge);
            try (RunTrack written = track.isPresent() ? new RunTrack(track.get(), simulation) : null) {
                if (written != null) {
                    simulation.addStepListener(written::stepped);
                }
                simulate(simulation, judge);
            }
            if (recorder != null) {
                recorder.finish();
            }
        }
    }

    /** {@code --runs N}: a line of CSV for each of N seeds, counting up. */
    private int runAll() throws UsageException, IOException {
        refuse(arguments, List.of("record", "track"), ": a file holds one run, expected no --runs beside it");
        long runs = arguments.integer("runs", 1, 1, MAX_RUNS);
        PrintStream out = Program.standardOutput();
        out.println(RunJudge.HEADER);
        boolean isAllDone = true;
        for (long run = seed; run < seed + runs; run++) {
            Simulation simulation = simulation(run);
            RunJudge judge = judge(simulation);
            try {
                begin(simulation, judge);
                simulate(simulation, judge);
            } finally {
                endAll(simulation);
            }
            out.println(judge.row(run));
            isAllDone &= judge.isAllDone();
        }
        return isAllDone ? ExitStatus.OK : ExitStatus.FAILED;
    }

    private RunJudge judge(Simulation simulation) throws UsageException {
        judge = new RunJudge(simulation, behaviours.chosenForRun(arguments, simulation.behaviours()), goal);
        return judge;
    }

    /** A process ends the program: says so for the run that is under way. Called on another thread. */
    private void broken(Decision.Failed fault) {
        judge.end(RunOutcome.State.FAILED, fault.where() + fault.text());
        PrintStream out = Program.standardOutput();
        judge.outcomes().forEach(outcome -> out.println(outcome.event()));
        out.flush();
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

    private void begin(Simulation simulation, RunJudge judge) throws UsageException {
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        boolean power = arguments.choice("power", "on", "off").equals("on");
        for (SimulatedRobot robot : simulation.robots()) {
            robot.setMotors(motors);
            robot.setPower(power);
        }
        judge.begin();
    }

    private void simulate(Simulation simulation, RunJudge judge) {
        long left = Math.round(seconds * 1e9 / Simulation.STEP_NANOS);
        while (left-- > 0 && !(isUntilDone && judge.isDecided())) {
            simulation.step();
        }
        judge.end(RunOutcome.State.TIMEOUT, "");
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
}
