package simrobot.p2os;

import java.util.List;
import java.util.stream.IntStream;
import simrobot.robot.SimulatedRobot;
import vericommand.Pose;

/**
 * A client on a robot, from the handshake to its leaving. Belongs to the simulation's thread; time comes in with the
 * bytes and with {@link #tick}.
 *
 * <p>Two times run here. Information packets follow simulated time, one each 100 ms of it, so that at any speed a step
 * from one to the next is a robot's step; only, a client hears from a slow or paused simulation every 200 ms of real
 * time, and from a fast one not more often than every 10 ms. The watchdog guards the line, so it goes by real time.
 */
public final class P2osSession {
    static final int SIP_MILLIS = 100;

    private static final long SIP_NANOS = SIP_MILLIS * 1_000_000L;
    private static final long LEAST_GAP_NANOS = 10_000_000;
    private static final long MOST_GAP_NANOS = 200_000_000;

    /** A client that says nothing for so long may have lost its robot: the robot stops. */
    public static final long WATCHDOG_NANOS = 2_000_000_000;

    private enum Stage {
        HANDSHAKE,
        /** The client knows who we are and may open. */
        INTRODUCED,
        OPEN,
        ENDED
    }

    private final SimulatedRobot robot;
    private final Pose start;
    private final PacketOutput wire;
    private final P2osPacketReader reader = new P2osPacketReader(this::heard);
    private final P2osMotionCommands motion;
    private final P2osReports report;
    private final StallDetector stall;
    private volatile Stage stage = Stage.HANDSHAKE;
    private ReportMode encoders = ReportMode.NEVER;
    private ReportMode simulator = ReportMode.NEVER;
    private boolean silent;
    private long simulatedNanos;
    private long nanos;
    private volatile long heardNanos;
    private long sipSimulatedNanos;
    private long sipNanos;

    /**
     * @param start where the robot is put when the client resets the simulator
     * @param nanos real time now
     */
    public P2osSession(SimulatedRobot robot, Pose start, PacketOutput wire, long nanos) {
        this.robot = robot;
        this.start = start;
        this.wire = wire;
        motion = new P2osMotionCommands(robot);
        stall = new StallDetector(robot);
        report = new P2osReports(robot, stall);
        heardNanos = nanos;
    }

    /** Takes any bytes whatever. */
    public void received(byte[] bytes, long nowSimulatedNanos, long nowNanos) {
        setTime(nowSimulatedNanos, nowNanos);
        if (stage != Stage.ENDED) {
            reader.read(bytes, nowNanos);
        }
    }

    /** Time has passed; to be told after every step, and now and then while the simulation stands. */
    public void tick(long nowSimulatedNanos, long nowNanos) {
        setTime(nowSimulatedNanos, nowNanos);
        if (stage == Stage.ENDED) {
            return;
        }
        if (!robot.isPowered()) {
            leave();
            return;
        }
        if (stage == Stage.OPEN) {
            if (!silent && nanos - heardNanos > WATCHDOG_NANOS) {
                silent = true;
                motion.setSuspended(true);
            }
            tellWhenDue();
        }
    }

    /** The client is gone. */
    public void lost() {
        if (stage == Stage.OPEN) {
            motion.end();
        }
        stage = Stage.ENDED;
    }

    /** Whether the client has come as far as to be heeded. Any thread may ask. */
    public boolean isOpen() {
        return stage == Stage.OPEN;
    }

    /** When the client last said something, or came; real time. Any thread may ask. */
    public long heardNanos() {
        return heardNanos;
    }

    private void setTime(long nowSimulatedNanos, long nowNanos) {
        simulatedNanos = nowSimulatedNanos;
        nanos = nowNanos;
        stall.watch(simulatedNanos);
    }

    private void heard(byte[] data) {
        if (stage == Stage.ENDED) {
            return;
        }
        heardNanos = nanos;
        if (silent) {
            silent = false;
            motion.setSuspended(false);
        }
        P2osCommand command = P2osCommandCodec.decode(data);
        if (command instanceof P2osCommand.Pulse) {
            pulse();
        } else if (command instanceof P2osCommand.Open) {
            open();
        } else if (command instanceof P2osCommand.Close) {
            close();
        } else if (stage == Stage.OPEN) {
            perform(command);
        }
    }

    // ---- coming and going ----------------------------------------------------------------------------------------

    private void pulse() {
        if (stage != Stage.OPEN) {
            stage = Stage.HANDSHAKE;
            wire.send(P2osCommandCodec.packet(P2osCommandNumber.PULSE));
        }
    }

    private void open() {
        if (stage == Stage.HANDSHAKE) {
            wire.send(P2osCommandCodec.packet(P2osCommandNumber.OPEN));
        } else if (stage == Stage.INTRODUCED) {
            stage = Stage.OPEN;
            motion.begin();
            tell();
        }
    }

    private void close() {
        if (stage == Stage.OPEN) {
            leave();
        } else {
            stage = Stage.INTRODUCED;
            wire.send(report.introduction());
        }
    }

    /** Stops the robot and hangs up. */
    void leave() {
        lost();
        wire.close();
    }

    // ---- commands ------------------------------------------------------------------------------------------------

    private void perform(P2osCommand command) {
        if (command instanceof P2osCommand.Enable enable) {
            robot.setMotors(enable.motors());
        } else if (command instanceof P2osCommand.SetOrigin) {
            robot.resetOdometry();
        } else if (command instanceof P2osCommand.Configuration) {
            wire.send(ConfigurationPacket.of(report.name()));
        } else if (command instanceof P2osCommand.Encoders wanted) {
            encoders = ReportMode.ofMode(wanted.mode());
        } else if (command instanceof P2osCommand.SimStatus wanted) {
            simulator = ReportMode.ofMode(wanted.mode());
        } else if (command instanceof P2osCommand.Sonar sonar) {
            report.setSonar(sonar.on());
        } else if (command instanceof P2osCommand.Polling polling) {
            report.setPolled(polling.sonars());
        } else if (command instanceof P2osCommand.BumpStall sides) {
            stall.setBumpers(sides);
        } else if (command instanceof P2osCommand.Battery battery) {
            robot.battery().setVolts(Math.max(0, Math.min(0xFF, battery.decivolts())) / 10.0);
        } else if (command instanceof P2osCommand.SimPose pose) {
            place(pose.x() / 1000.0, pose.y() / 1000.0, Math.toRadians(pose.heading()));
        } else if (command instanceof P2osCommand.SimReset) {
            place(start.xMeters(), start.yMeters(), Math.toRadians(start.headingDegrees()));
            robot.resetOdometry();
        } else {
            motion.perform(command);
        }
    }

    /** An order by telephone is not interrupted by the robot's being carried away. */
    private void place(double x, double y, double heading) {
        if (!robot.isUnderOrder()) {
            robot.brakeAtOnce();
            robot.place(x, y, heading);
        }
    }

    // ---- information packets -------------------------------------------------------------------------------------

    private void tellWhenDue() {
        long gap = nanos - sipNanos;
        boolean due = simulatedNanos - sipSimulatedNanos >= SIP_NANOS && gap >= LEAST_GAP_NANOS;
        if (due || gap >= MOST_GAP_NANOS) {
            tell();
        }
    }

    private void tell() {
        boolean late = simulatedNanos - sipSimulatedNanos >= 2 * SIP_NANOS;
        sipSimulatedNanos =
                late || simulatedNanos - sipSimulatedNanos < SIP_NANOS ? simulatedNanos : sipSimulatedNanos + SIP_NANOS;
        sipNanos = nanos;
        wire.send(report.standard(simulatedNanos));
        if (encoders != ReportMode.NEVER) {
            encoders = encoders.afterTelling();
            wire.send(report.encoders());
        }
        if (simulator != ReportMode.NEVER) {
            simulator = simulator.afterTelling();
            wire.send(report.simulator());
        }
    }

    /** All sonars, sonar 0 first. */
    static List<Integer> allSonars() {
        return IntStream.range(0, StandardSip.SONARS).boxed().toList();
    }
}
