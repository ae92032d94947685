package simrobot.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** A robot in a simulation whose steps the test makes, a modem that only writes down, and the console's lines. */
final class ControlBench implements ModemPort {
    /** A wall 1 m east of the robot's start, so that 75 cm are free. */
    private static final World WALL = World.of("wall", List.of(new Segment(1, -2, 1, 2)));

    final Simulation simulation = new Simulation(WALL, 1);
    final SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
    final RobotControl control;
    final List<String> log = new ArrayList<>();

    ControlBench() {
        this(VeriCommandSettings.OnHangup.STOP);
    }

    ControlBench(VeriCommandSettings.OnHangup onHangup) {
        VeriCommandSettings settings = new VeriCommandSettings(Locale.ENGLISH, Set.of(), onHangup);
        control = new RobotControl(robot, settings, this, simulation::timeNanos);
        control.listen(event -> log.add(event.line("robot").toString()));
    }

    @Override
    public void say(long call, String reply) {
        log.add("modem: says " + reply);
    }

    @Override
    public boolean listen(long call) {
        log.add("listens");
        return true;
    }

    void press(String keys) {
        keys.chars().forEach(key -> control.key((char) key, simulation.timeNanos()));
    }

    void seconds(double seconds) {
        simulation.run((int) Math.round(seconds * 1e9 / Simulation.STEP_NANOS));
    }

    /** The lines so far that begin so, and forgets all. */
    List<String> lines(String... beginnings) {
        List<String> found = log.stream()
                .filter(line -> List.of(beginnings).stream().anyMatch(line::startsWith))
                .toList();
        log.clear();
        return found;
    }

    @Override
    public void sendTone(long call, char key) {
        log.add("modem: tone " + key);
    }

    @Override
    public void clearCall(long call) {
        log.add("modem: clear");
    }

    @Override
    public boolean sendMessage(String to, String text) {
        return !to.equals("nobody");
    }

    @Override
    public void setOrderUnderWay(boolean underWay) {
        log.add("modem: under way " + underWay);
    }
}
