package simrobot.pioneer;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import simrobot.p2os.P2osSession;
import simrobot.p2os.PacketOutput;
import simrobot.p2os.SimulatorRequests;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;

/** A real robot's core whose line leads to our own P2OS session on a simulated one; time moves by hand, both ways take 10 ms. */
final class LineBench {
    private static final long STEP_NANOS = Simulation.STEP_NANOS;

    final SimulatedRobot body;
    final RealPioneer robot;
    final List<RobotStatus> statuses = new ArrayList<>();
    final List<MotionOutcome> outcomes = new ArrayList<>();
    final List<byte[]> sent = new ArrayList<>();
    boolean wanted;
    int drops;
    /** Whether what the robot sends is lost. */
    boolean deaf;

    private final Simulation simulation;
    private final Deque<byte[]> toRobot = new ArrayDeque<>();
    private final Deque<byte[]> toUs = new ArrayDeque<>();
    private P2osSession session;
    private boolean closedByRobot;
    private long nanos = 1_000_000_000;

    LineBench(World world) {
        simulation = new Simulation(world, 1);
        body = simulation.addRobot("body", new Position(0, 0), 0);
        robot = new RealPioneer("robot", new Ours(), new Pose(0, 0, 0), true, Optional.empty(), new MapOnly(world));
        robot.addStatusListener(statuses::add);
    }

    static LineBench connected(World world) {
        LineBench bench = new LineBench(world);
        bench.connect();
        bench.seconds(0.5);
        return bench;
    }

    private final class Ours implements PioneerLine {
        @Override
        public void send(byte[] packet) {
            sent.add(packet);
            toRobot.add(packet);
        }

        @Override
        public void call() {
            wanted = true;
        }

        @Override
        public void drop() {
            drops++;
            cutLine();
        }

        @Override
        public void hangUp() {
            wanted = false;
            cutLine();
        }
    }

    /** There is a line now. */
    void connect() {
        closedByRobot = false;
        session = new P2osSession(
                body,
                body.pose(),
                new PacketOutput() {
                    @Override
                    public void send(byte[] packet) {
                        toUs.add(packet);
                    }

                    @Override
                    public void close() {
                        closedByRobot = true;
                    }
                },
                new SimulatorRequests() {},
                nanos);
        robot.connected(nanos);
    }

    /** There is none any more. */
    void cutLine() {
        if (session != null) {
            session.lost();
            session = null;
            toRobot.clear();
            toUs.clear();
            robot.disconnected();
        }
    }

    LineBench seconds(double seconds) {
        for (long i = 0; i < Math.round(seconds * 1e9 / STEP_NANOS); i++) {
            step();
        }
        return this;
    }

    private void step() {
        nanos += STEP_NANOS;
        simulation.step();
        if (session != null) {
            for (int i = toRobot.size(); i > 0 && session != null; i--) {
                session.received(toRobot.remove(), simulation.timeNanos(), nanos);
            }
            session.tick(simulation.timeNanos(), nanos);
        }
        for (int i = toUs.size(); i > 0 && !toUs.isEmpty(); i--) {
            byte[] packet = toUs.remove();
            if (!deaf) {
                robot.received(packet, nanos);
            }
        }
        if (closedByRobot) {
            cutLine();
        }
        if (nanos % 100_000_000 == 0) {
            robot.tick(nanos);
        }
    }

    /** Orders it and gives it time to do it. */
    MotionOutcome order(Instruction.Motion motion) {
        int before = outcomes.size();
        robot.start(motion, outcomes::add);
        for (int i = 0; i < 100_000 && outcomes.size() == before; i++) {
            step();
        }
        return outcomes.get(before);
    }
}
