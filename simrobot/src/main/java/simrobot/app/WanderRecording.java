package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simrobot.behaviour.BehaviourKind;
import simrobot.control.RobotEventPrinter;
import simrobot.replay.SessionRecorder;
import simrobot.robot.RobotState;
import simrobot.simulation.Simulation;
import simrobot.simulation.WanderRun;
import simrobot.world.World;
import vericommand.RobotStatus;

/**
 * Records a {@link WanderRun} as any session is: a simulation whose robots are put, after each of the run's steps, where the
 * run has them. Between two of them they stand, as they do by the rule, where speeds hold for 100 ms.
 */
final class WanderRecording implements AutoCloseable {
    private static final long STEPS = WanderRun.STEP_NANOS / Simulation.STEP_NANOS;

    private final WanderRun run;
    private final Simulation stage;
    private final SessionRecorder recorder;
    private final double[] startX;
    private final double[] startY;
    private final double[] startHeading;

    private WanderRecording(Path file, World world, WanderRun run, List<String> names) throws IOException {
        this.run = run;
        startX = new double[run.robots()];
        startY = new double[run.robots()];
        startHeading = new double[run.robots()];
        List<RobotState> states = new ArrayList<>();
        for (int i = 0; i < run.robots(); i++) {
            startX[i] = run.xMeters(i);
            startY[i] = run.yMeters(i);
            startHeading[i] = run.headingRadians(i);
            states.add(state(i));
        }
        stage = new Simulation(world, 0);
        stage.restoreRobots(names, states);
        // nobody runs acts here, so what is recorded is written as there is enough of it
        recorder = SessionRecorder.open(file, stage, act -> {});
        for (String name : names) {
            RobotEventPrinter events = new RobotEventPrinter(name, recorder::event);
            events.behaviour(BehaviourKind.WANDER);
            events.status(RobotStatus.MOVING);
        }
    }

    /**
     * Begins with where the run's robots are now.
     *
     * @throws IOException if the file cannot be written
     */
    static WanderRecording open(Path file, World world, WanderRun run, List<String> names) throws IOException {
        return new WanderRecording(file, world, run, names);
    }

    /** The run has made a step. */
    void step() {
        for (long left = STEPS; left > 1; left--) {
            stage.restoredStep();
        }
        for (int i = 0; i < run.robots(); i++) {
            stage.robots().get(i).restore(state(i));
        }
        stage.restoredStep();
    }

    /** By the rule odometry is perfect; like every robot's it begins at nought. */
    private RobotState state(int i) {
        double dx = run.xMeters(i) - startX[i];
        double dy = run.yMeters(i) - startY[i];
        double cos = StrictMath.cos(startHeading[i]);
        double sin = StrictMath.sin(startHeading[i]);
        return new RobotState(
                run.xMeters(i),
                run.yMeters(i),
                run.headingRadians(i),
                run.speedMetersPerSecond(i),
                run.turnRadiansPerSecond(i),
                dx * cos + dy * sin,
                dy * cos - dx * sin,
                run.headingRadians(i) - startHeading[i],
                RobotStatus.MOVING,
                BehaviourKind.WANDER);
    }

    @Override
    public void close() {
        recorder.close();
    }
}
