package simrobot.app;

import java.io.IOException;
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
import simrobot.SimRobotMain;
import simrobot.behaviour.BehaviourKind;
import simrobot.control.RobotEventPrinter;
import simrobot.control.RobotName;
import simrobot.replay.SessionRecorder;
import simrobot.robot.Noise;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.WanderRun;
import simrobot.world.World;

/**
 * {@code --run SECONDS}: simulates so long, as fast as the machine can, on the main thread alone: no centre, no modem, no
 * console. Robots that wander do so by the very rule with which simulators are compared ({@link WanderRun}).
 */
public final class BatchRun {
    private static final double MOST_SECONDS = 1e9;
    /** What needs real time or somebody at the other end. */
    private static final List<String> LIVE_OPTIONS = List.of("pioneer", "http", "p2os");

    private BatchRun() {}

    public static int run(Arguments arguments, World world) throws UsageException, IOException {
        for (String live : LIVE_OPTIONS) {
            if (arguments.has(live)) {
                throw new UsageException(
                        "--" + live + ": there is nobody to serve with --run, expected one of the two");
            }
        }
        List<RobotName> robots = RequestedRobots.of(arguments, SimSlot.of(arguments.path("sim")), world);
        BehaviourKind behaviour = SimRobotMain.behaviour(arguments);
        double seconds = arguments.number("run", 0, 0.001, MOST_SECONDS);
        long began = System.nanoTime();
        if (behaviour == BehaviourKind.WANDER) {
            wander(arguments, world, robots, seconds);
        } else {
            simulate(arguments, world, robots, behaviour, seconds);
        }
        double wall = (System.nanoTime() - began) * 1e-9;
        Program.standardOutput()
                .println(Event.of("ran")
                        .with("robots", robots.size())
                        .with("simulated", three(seconds))
                        .with("cpu", three(cpuSeconds()))
                        .with("wall", three(wall)));
        return ExitStatus.OK;
    }

    private static void wander(Arguments arguments, World world, List<RobotName> robots, double seconds)
            throws UsageException, IOException {
        WanderRun run = new WanderRun(world, robots.size());
        long steps = Math.round(seconds * 1e9 / WanderRun.STEP_NANOS);
        Optional<Path> file = arguments.path("record");
        if (file.isEmpty()) {
            for (long left = steps; left > 0; left--) {
                run.step();
            }
            return;
        }
        List<String> names = robots.stream().map(RobotName::name).toList();
        try (WanderRecording recording = WanderRecording.open(file.get(), world, run, names)) {
            for (long left = steps; left > 0; left--) {
                run.step();
                recording.step();
            }
        }
    }

    private static void simulate(
            Arguments arguments, World world, List<RobotName> robots, BehaviourKind behaviour, double seconds)
            throws UsageException, IOException {
        Simulation simulation = new Simulation(world, SimRobotMain.seed(arguments));
        simulation.setNoise(arguments.number("noise", 0, 0, Noise.MOST));
        simulation.addRobots(robots.stream().map(RobotName::name).toList());
        Optional<Path> file = arguments.path("record");
        // nobody runs acts here, so what is recorded is written as there is enough of it
        Optional<SessionRecorder> recorder = file.isPresent()
                ? Optional.of(SessionRecorder.open(file.get(), simulation, act -> {}))
                : Optional.empty();
        for (SimulatedRobot robot : simulation.robots()) {
            recorder.ifPresent(events -> listen(robot, new RobotEventPrinter(robot.name(), events::event)));
            robot.setMotors(arguments.choice("motors", "on", "off").equals("on"));
            robot.setPower(arguments.choice("power", "on", "off").equals("on"));
            robot.autonomy().begin(behaviour);
        }
        for (long left = Math.round(seconds * 1e9 / Simulation.STEP_NANOS); left > 0; left--) {
            simulation.step();
        }
        recorder.ifPresent(SessionRecorder::close);
    }

    private static void listen(SimulatedRobot robot, RobotEventPrinter events) {
        robot.addStatusListener(events::status);
        robot.autonomy().addListener(events::behaviour);
    }

    /** Of the whole process from its start, user and system. */
    private static double cpuSeconds() {
        return ProcessHandle.current()
                        .info()
                        .totalCpuDuration()
                        .orElse(Duration.ZERO)
                        .toNanos()
                * 1e-9;
    }

    private static String three(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
