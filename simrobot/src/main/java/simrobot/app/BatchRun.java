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
import simrobot.control.RobotEvent;
import simrobot.control.RobotName;
import simrobot.process.BehaviourKind;
import simrobot.replay.SessionRecorder;
import simrobot.robot.Noise;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/**
 * {@code --run SECONDS}: simulates that long, as fast as the machine can, on the main thread alone: no centre, no modem, no
 * console. The simulation is the one that windows and consoles use.
 */
public final class BatchRun {
    private static final double MAX_SECONDS = 1e9;

    /** Options that need real time or a peer. */
    private static final List<String> LIVE_OPTIONS = List.of("pioneer", "http", "p2os");

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
        long seed = SimRobotMain.seed(arguments);
        double noise = arguments.number("noise", 0, 0, Noise.MAX_SCALE);
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        boolean power = arguments.choice("power", "on", "off").equals("on");
        double seconds = arguments.number("run", 0, 0.001, MAX_SECONDS);
        Optional<Path> file = arguments.path("record");
        long began = System.nanoTime();
        Simulation simulation = new Simulation(world, seed);
        BehaviourKind behaviour =
                RequestedBehaviours.of(arguments, simulation.behaviours()).chosen(arguments);
        simulation.setNoise(noise);
        simulation.setTrails(false);
        simulation.addRobots(names);
        // without a thread that performs acts, records are written when they are full
        Optional<SessionRecorder> recorder = file.isPresent()
                ? Optional.of(SessionRecorder.open(file.get(), simulation, act -> {}))
                : Optional.empty();
        for (SimulatedRobot robot : simulation.robots()) {
            recorder.ifPresent(open -> record(robot, open));
            robot.setMotors(motors);
            robot.setPower(power);
            robot.autonomy().begin(behaviour);
        }
        for (long left = Math.round(seconds * 1e9 / Simulation.STEP_NANOS); left > 0; left--) {
            simulation.step();
        }
        recorder.ifPresent(SessionRecorder::close);
        double wall = (System.nanoTime() - began) * 1e-9;
        Program.standardOutput()
                .println(Event.of("ran")
                        .with("robots", names.size())
                        .with("simulated", threeDecimals(seconds))
                        .with("cpu", threeDecimals(cpuSeconds()))
                        .with("wall", threeDecimals(wall)));
        return ExitStatus.OK;
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
