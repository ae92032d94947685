package simrobot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.speech.Loudspeaker;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.SimulationThread;
import simrobot.ui.LineSnapshot;
import simrobot.ui.Operator;
import simrobot.ui.WindowSnapshot;
import simrobot.world.World;
import simrobot.world.WorldReader;

/** The program as its window sees it: pictures from every thread's newest snapshots, acts to the threads that own things. */
final class WindowModel implements Operator {
    private static final long NOTICE_NANOS = TimeUnit.SECONDS.toNanos(12);

    private final SimulationThread simulation;
    private final Loudspeaker loudspeaker;
    private volatile Path worldFile;
    private volatile String notice = "";
    private volatile long noticeNanos;
    private final List<Line> lines;
    private WindowSnapshot newest;

    /** A robot with its telephone, and what it has answered. */
    private record Line(TelephoneRobot robot, SentTones sent) {}

    /** To be made before the start, for it listens to the robots. */
    WindowModel(SimRobot simRobot, Path worldFile) {
        this.worldFile = worldFile;
        simulation = simRobot.simulation();
        loudspeaker = simRobot.loudspeaker();
        lines = simRobot.robots().stream()
                .map(robot -> new Line(robot, new SentTones()))
                .toList();
        lines.forEach(line -> line.robot().listen(line.sent()));
    }

    /** The newest picture; the same object as long as nothing has changed. Asked by the event thread only. */
    WindowSnapshot snapshot() {
        WindowSnapshot now = new WindowSnapshot(
                simulation.snapshot(),
                lines.stream().map(this::picture).toList(),
                simulation.speed(),
                simulation.isPaused(),
                worldFile,
                System.nanoTime() - noticeNanos < NOTICE_NANOS ? notice : "");
        if (!now.equals(newest)) {
            newest = now;
        }
        return newest;
    }

    private LineSnapshot picture(Line line) {
        TelephoneRobot robot = line.robot();
        return new LineSnapshot(
                robot.name(),
                robot.number().digits(),
                robot.modem(),
                robot.heard(),
                robot.veriCommand(),
                line.sent().tones(),
                loudspeaker.isAudible());
    }

    /** A window that is gone needs no pictures; a robot that is gone gets no acts. */
    private void act(String robot, Consumer<SimulatedRobot> act) {
        simulation.withSimulation(owned -> owned.robot(robot).ifPresent(act));
    }

    @Override
    public void setPower(String robot, boolean on) {
        act(robot, owned -> owned.setPower(on));
    }

    @Override
    public void setMotors(String robot, boolean on) {
        act(robot, owned -> owned.setMotors(on));
    }

    @Override
    public void place(String robot, double xMeters, double yMeters, double headingRadians) {
        act(robot, owned -> owned.place(xMeters, yMeters, headingRadians));
    }

    @Override
    public void brake(String robot) {
        act(robot, SimulatedRobot::brake);
    }

    @Override
    public void watch(String robot) {
        loudspeaker.choose(robot);
        simulation.withSimulation(owned -> owned.watch(owned.robot(robot).orElse(null)));
    }

    @Override
    public void setSpeed(double simulatedSecondsPerSecond) {
        simulation.setSpeed(simulatedSecondsPerSecond);
    }

    @Override
    public void setPaused(boolean paused) {
        simulation.setPaused(paused);
    }

    @Override
    public void stepOnce() {
        simulation.stepOnce();
    }

    @Override
    public void load(Path file) {
        Thread reader = new Thread(() -> read(file), "world reader");
        reader.setDaemon(true);
        reader.start();
    }

    /** A file that is no world leaves everything as it was, and says why. */
    void read(Path file) {
        try {
            World world = WorldReader.read(file);
            simulation.withSimulation(owned -> {
                try {
                    owned.load(world);
                    worldFile = file;
                    tell("");
                } catch (IllegalArgumentException tooSmall) {
                    tell(tooSmall.getMessage());
                }
            });
        } catch (java.nio.file.NoSuchFileException missing) {
            tell(file + ": no such file");
        } catch (IOException unreadable) {
            tell(unreadable.getMessage());
        }
    }

    private void tell(String message) {
        noticeNanos = System.nanoTime();
        notice = message;
    }

    /** For the title. */
    String firstNumber() {
        return lines.isEmpty() ? "" : lines.get(0).robot().number().digits();
    }
}
