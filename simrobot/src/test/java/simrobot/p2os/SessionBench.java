package simrobot.p2os;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/** A robot between a wall 1 m ahead and one 2 m behind, a session, and both clocks in the test's hand. */
final class SessionBench implements PacketOutput {
    private static final World WALLS = World.of("walls", List.of(new Segment(1, -3, 1, 3), new Segment(-2, -3, -2, 3)));

    final Simulation simulation;
    final SimulatedRobot robot;
    final P2osSession session;
    final List<byte[]> heard = new ArrayList<>();
    boolean closed;
    long nanos = 77_000_000_000L;
    private boolean alive = true;
    private int steps;

    SessionBench() {
        this(WALLS);
    }

    SessionBench(World world) {
        simulation = new Simulation(world, 1);
        robot = simulation.addRobot("robot", new Position(0, 0), 0);
        session = new P2osSession(robot, robot.pose(), this, new SimulatorRequests() {}, nanos);
    }

    static SessionBench opened() {
        SessionBench bench = new SessionBench();
        bench.open();
        return bench;
    }

    static SessionBench openedOnBareFloor() {
        SessionBench bench = new SessionBench(World.bare());
        bench.open();
        return bench;
    }

    void open() {
        say(P2osCommandNumber.PULSE);
        say(P2osCommandNumber.OPEN);
        say(P2osCommandNumber.CLOSE);
        heard.clear();
        say(P2osCommandNumber.OPEN, 1);
    }

    @Override
    public void send(byte[] packet) {
        heard.add(Arrays.copyOfRange(packet, 3, packet.length - 2));
    }

    @Override
    public void close() {
        closed = true;
    }

    SessionBench say(int number) {
        return say(P2osCommand.packet(number));
    }

    SessionBench say(int number, int argument) {
        return say(P2osCommand.packet(number, argument));
    }

    SessionBench say(byte[] bytes) {
        session.received(bytes, simulation.timeNanos(), nanos);
        return this;
    }

    /** The client says nothing from here on, not even pulses. */
    SessionBench fallSilent() {
        alive = false;
        return this;
    }

    SessionBench seconds(double seconds) {
        return seconds(seconds, 1);
    }

    /** @param speed simulated seconds a second */
    SessionBench seconds(double seconds, double speed) {
        int count = (int) Math.round(seconds * 1e9 / Simulation.STEP_NANOS);
        for (int i = 0; i < count; i++) {
            simulation.step();
            nanos += (long) (Simulation.STEP_NANOS / speed);
            session.tick(simulation.timeNanos(), nanos);
            if (alive && ++steps % 50 == 0) {
                say(P2osCommandNumber.PULSE);
            }
        }
        return this;
    }

    List<Sip> sips() {
        return heard.stream()
                .filter(data -> data[0] == InformationPacket.STOPPED_ID || data[0] == InformationPacket.MOVING_ID)
                .map(Sip::of)
                .toList();
    }

    Sip sip() {
        List<Sip> all = sips();
        return all.get(all.size() - 1);
    }

    /** The packets with this id so far. */
    List<byte[]> packets(int id) {
        return heard.stream().filter(data -> (data[0] & 0xFF) == id).toList();
    }
}
