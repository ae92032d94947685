package simrobot.pioneer;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import simrobot.p2os.P2osCommandNumber;
import simrobot.p2os.P2osPacket;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;

/**
 * A robot of any type by its own units, at the other end of a line: it knows VEL, RVEL, STOP, ENABLE, SETA and SETRA only,
 * no MOVE and no HEAD. Its pose is exact; only what it reports is rounded to its units.
 */
final class FakePioneer implements PioneerLine {
    private static final long STEP_NANOS = 10_000_000;

    /** How the body follows a commanded speed, and how the line treats packets. */
    record Manner(double lagSeconds, double deadBand, int delayMillis, int cycleMillis, int loses) {
        static final Manner PROMPT = new Manner(0, 0, 10, 100, 0);
    }

    private record Delayed(byte[] packet, long nanos) {}

    final List<MotionOutcome> outcomes = new ArrayList<>();
    final List<Integer> commands = new ArrayList<>();
    final RealPioneer robot;
    double x;
    double y;
    double heading;
    boolean motors;
    /** Pressed bumpers, five bits each. */
    int front;

    int rear;
    /** It sends nothing, but hears. */
    boolean silent;

    private final String subclass;
    private final RobotKind kind;
    private final Manner manner;
    private final Deque<Delayed> toRobot = new ArrayDeque<>();
    private final Deque<Delayed> toUs = new ArrayDeque<>();
    private long nanos = 1_000_000_000;
    private boolean opened;
    private int reports;
    private double wanted;
    private double wantedTurn;
    private double speed;
    private double turn;
    private double acceleration = 300;
    private double turnAcceleration = 100;

    FakePioneer(String subclass, RobotKind kind, Manner manner, Optional<RobotParameters> parameters) {
        this.subclass = subclass;
        this.kind = kind;
        this.manner = manner;
        robot = new RealPioneer("robot", this, new Pose(0, 0, 0), true, parameters, new MapOnly(World.bare()));
        // the odometry begins shortly before it wraps
        x = 32.7 * kind.millimetersPerUnit();
        robot.connected(nanos);
        seconds(1);
    }

    @Override
    public void send(byte[] packet) {
        toRobot.add(new Delayed(packet, nanos + manner.delayMillis * 1_000_000L));
    }

    @Override
    public void call() {}

    @Override
    public void drop() {
        robot.disconnected();
    }

    @Override
    public void hangUp() {}

    FakePioneer seconds(double seconds) {
        for (long end = nanos + Math.round(seconds * 1e9); nanos < end; ) {
            step();
        }
        return this;
    }

    MotionOutcome order(Instruction.Motion motion) {
        int before = outcomes.size();
        robot.start(motion, outcomes::add);
        for (int i = 0; i < 100_000 && outcomes.size() == before; i++) {
            step();
        }
        return outcomes.get(before);
    }

    private void step() {
        nanos += STEP_NANOS;
        while (!toRobot.isEmpty() && toRobot.peek().nanos <= nanos) {
            obey(toRobot.remove().packet);
        }
        move();
        if (nanos / 1_000_000 % manner.cycleMillis == 0 && opened && !silent) {
            reports++;
            if (manner.loses == 0 || reports % manner.loses != 0) {
                answer(sip());
            }
        }
        while (!toUs.isEmpty() && toUs.peek().nanos <= nanos) {
            robot.received(toUs.remove().packet, nanos);
        }
        if (nanos % 100_000_000 == 0) {
            robot.tick(nanos);
        }
    }

    private void answer(byte[] data) {
        toUs.add(new Delayed(P2osPacket.of(data), nanos + manner.delayMillis * 1_000_000L));
    }

    private void obey(byte[] packet) {
        int command = packet[3] & 0xFF;
        commands.add(command);
        int argument =
                packet.length < 9 ? 0 : (packet[5] & 0xFF | (packet[6] & 0xFF) << 8) * (packet[4] == 0x3B ? 1 : -1);
        if (packet.length < 9 && command <= 2 && !opened) {
            String names = command < 2 ? "" : "fake\0Pioneer\0" + subclass + "\0";
            answer(((char) command + names).getBytes(StandardCharsets.ISO_8859_1));
            return;
        }
        switch (command) {
            case P2osCommandNumber.OPEN -> opened = true;
            case P2osCommandNumber.ENABLE -> motors = argument != 0;
            case P2osCommandNumber.VEL -> wanted = argument;
            case P2osCommandNumber.RVEL -> wantedTurn = argument;
            case P2osCommandNumber.SETA -> acceleration = Math.abs(argument);
            case P2osCommandNumber.SETRA -> turnAcceleration = Math.abs(argument);
            case P2osCommandNumber.STOP -> {
                wanted = 0;
                wantedTurn = 0;
            }
            default -> {
                // not known to it
            }
        }
    }

    private void move() {
        double dt = STEP_NANOS / 1e9;
        speed = follow(speed, motors ? wanted : 0, acceleration, dt, 1);
        turn = follow(turn, motors ? wantedTurn : 0, turnAcceleration, dt, 0.1);
        x += speed * Math.cos(heading) * dt;
        y += speed * Math.sin(heading) * dt;
        heading += Math.toRadians(turn) * dt;
    }

    private double follow(double now, double command, double limit, double dt, double least) {
        double target = Math.abs(command) < manner.deadBand * least ? 0 : command;
        double share = manner.lagSeconds == 0 ? 1 : dt / manner.lagSeconds;
        double change = Math.max(-limit * dt, Math.min(limit * dt, (target - now) * Math.min(1, share)));
        double next = now + change;
        return target == 0 && Math.abs(next) < 0.5 * least ? 0 : next;
    }

    private byte[] sip() {
        byte[] sip = new byte[20];
        boolean moves = speed != 0 || turn != 0;
        sip[0] = (byte) (moves ? 0x33 : 0x32);
        put(sip, 1, Math.round(x / kind.millimetersPerUnit()) & 0x7FFF);
        put(sip, 3, Math.round(y / kind.millimetersPerUnit()) & 0x7FFF);
        long angle = Math.round(heading / (2 * Math.PI) * kind.unitsPerTurn());
        put(sip, 5, Math.floorMod(angle, (long) kind.unitsPerTurn()));
        double half = Math.toRadians(turn) * 178;
        put(sip, 7, Math.round((speed - half) / kind.wheelSpeedFactor()));
        put(sip, 9, Math.round((speed + half) / kind.wheelSpeedFactor()));
        sip[11] = 127;
        sip[12] = (byte) (rear << 1);
        sip[13] = (byte) (front << 1);
        sip[16] = (byte) (motors ? 1 : 0);
        return sip;
    }

    private static void put(byte[] sip, int at, long value) {
        sip[at] = (byte) value;
        sip[at + 1] = (byte) (value >> 8);
    }
}
