package simrobot.p2os;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.stream.IntStream;
import simgsm.state.StateMachine;
import simrobot.p2os.P2osSessionTable.Action;
import simrobot.p2os.P2osSessionTable.P2osEvent;
import simrobot.p2os.P2osSessionTable.State;
import simrobot.robot.SimulatedRobot;
import simrobot.robot.SonarRing;
import vericommand.Pose;

/**
 * A client's session on a robot, by {@link P2osSessionTable}. Owned by the simulation's thread; {@link #received} and
 * {@link #tick} supply the time.
 *
 * <p>Information packets follow simulated time, one per 100 ms of it, so that consecutive packets are one period apart
 * at any speed. In real time they are sent at least every 200 ms, from a slow or paused simulation too, and at most
 * every 10 ms. The watchdog guards the connection, so it runs in real time.
 */
public final class P2osSession {
    private static final Logger LOG = System.getLogger(P2osSession.class.getName());

    static final int SIP_MILLIS = 100;

    private static final long SIP_NANOS = SIP_MILLIS * 1_000_000L;
    private static final long MIN_GAP_NANOS = 10_000_000;
    private static final long MAX_GAP_NANOS = 200_000_000;

    /** Watchdog: the robot stops after this time without a packet from the client. */
    public static final long WATCHDOG_NANOS = 2_000_000_000;

    /** Rule for sending a further packet after an information packet. */
    private enum Repetition {
        NEVER,
        ONCE,
        ALWAYS;

        /** Decodes the mode: 0 never, 1 once, 2 always. */
        static Repetition of(int mode) {
            return mode == 1 ? ONCE : mode > 1 ? ALWAYS : NEVER;
        }
    }

    private final SimulatedRobot robot;
    private final Pose start;
    private final PacketOutput output;
    private final P2osPacketReader reader = new P2osPacketReader(this::receive);
    private final P2osMotionCommands motion;
    private final P2osReports reports;
    private final LaserReports laser;
    private final SimulatorRequests requests;
    private final StallDetector stall;
    private final StateMachine<State, P2osEvent, Action> machine;

    /** read by other threads */
    private volatile boolean open;

    private Repetition encoders = Repetition.NEVER;
    private Repetition simulator = Repetition.NEVER;
    private boolean silent;
    /** True if the previous packet of the same read was a pulse. */
    private boolean pulsed;

    private long simulatedNanos;
    private long nanos;
    private volatile long receivedNanos;
    private long sipSimulatedNanos;
    private long sipNanos;

    /**
     * Creates the session of a newly connected client.
     *
     * @param start the robot's pose after the client resets the simulator
     * @param nanos real time now
     */
    public P2osSession(SimulatedRobot robot, Pose start, PacketOutput output, SimulatorRequests requests, long nanos) {
        this.requests = requests;
        this.robot = robot;
        this.start = start;
        this.output = output;
        motion = new P2osMotionCommands(robot);
        stall = new StallDetector(robot);
        reports = new P2osReports(robot, stall);
        laser = new LaserReports(robot);
        machine = new StateMachine<>(P2osSessionTable.ROWS, robot.name(), this::perform);
        receivedNanos = nanos;
    }

    /**
     * Processes octets from the client; any content is valid input. A SYNC0 repeated in one read, because the answer is
     * late, is answered once.
     */
    public void received(byte[] octets, long nowSimulatedNanos, long nowNanos) {
        setTime(nowSimulatedNanos, nowNanos);
        pulsed = false;
        if (machine.state() != State.ENDED) {
            reader.read(octets, nowNanos);
        }
    }

    /** Advances the time; called after every step, and every 50 ms while the simulation makes none. */
    public void tick(long nowSimulatedNanos, long nowNanos) {
        setTime(nowSimulatedNanos, nowNanos);
        if (machine.state() == State.ENDED) {
            return;
        }
        if (!robot.isPowered()) {
            abort();
        } else if (machine.state() == State.OPEN) {
            if (!silent && nanos - receivedNanos > WATCHDOG_NANOS) {
                silent = true;
                motion.control().setSuspended(true);
            }
            sendWhenDue();
        }
    }

    /** Called when the connection is closed. */
    public void lost() {
        fire(P2osEvent.CONNECTION_LOST);
    }

    /** Stops the robot and closes the connection. */
    void abort() {
        fire(P2osEvent.ABORTED);
    }

    /** True if the client controls the robot. Callable on any thread. */
    public boolean isOpen() {
        return open;
    }

    /** Returns the time of the client's last packet, or of its connection; real time. Callable on any thread. */
    public long receivedNanos() {
        return receivedNanos;
    }

    private void setTime(long nowSimulatedNanos, long nowNanos) {
        simulatedNanos = nowSimulatedNanos;
        nanos = nowNanos;
        stall.watch(simulatedNanos);
    }

    private void receive(byte[] data) {
        if (machine.state() == State.ENDED) {
            return;
        }
        receivedNanos = nanos;
        if (silent) {
            silent = false;
            motion.control().setSuspended(false);
        }
        P2osCommand command = new P2osCommand(data);
        boolean isRepeated = pulsed;
        pulsed = command.number() == P2osCommandNumber.PULSE;
        switch (command.number()) {
            case P2osCommandNumber.PULSE -> {
                if (!isRepeated) {
                    fire(P2osEvent.PULSE_RECEIVED);
                }
            }
            case P2osCommandNumber.OPEN -> fire(P2osEvent.OPEN_RECEIVED);
            case P2osCommandNumber.CLOSE -> fire(P2osEvent.CLOSE_RECEIVED);
            default -> {
                if (machine.state() == State.OPEN) {
                    perform(command);
                }
            }
        }
    }

    private void fire(P2osEvent event) {
        machine.fire(event);
        open = machine.state() == State.OPEN;
    }

    private void perform(Action action) {
        switch (action) {
            case ECHO_PULSE -> output.send(P2osCommand.packet(P2osCommandNumber.PULSE));
            case ECHO_OPEN -> output.send(P2osCommand.packet(P2osCommandNumber.OPEN));
            case SEND_OUT_OF_ORDER -> output.send(P2osCommand.packet(P2osCommandNumber.OUT_OF_ORDER));
            case SEND_NAMES -> output.send(reports.introduction());
            case BEGIN_CONTROL -> {
                LOG.log(Level.INFO, robot.name() + ": a P2OS client takes control");
                motion.control().begin();
            }
            case SEND_INFORMATION -> sendInformation();
            case END_CONTROL -> {
                LOG.log(Level.INFO, robot.name() + ": the P2OS client has left");
                motion.control().end();
                laser.end();
            }
            case CLOSE_CONNECTION -> output.close();
        }
    }

    // ---- commands ------------------------------------------------------------------------------------------------

    private void perform(P2osCommand command) {
        switch (command.number()) {
            case P2osCommandNumber.SETO -> robot.resetOdometry();
            case P2osCommandNumber.STOP -> robot.brake();
            case P2osCommandNumber.E_STOP, P2osCommandNumber.E_STOP_OLD -> robot.brakeAtOnce();
            case P2osCommandNumber.CONFIG -> output.send(ConfigurationPacket.of(reports.name()));
            case P2osCommandNumber.POLLING -> command.sonars().ifPresent(reports::setPolled);
            case P2osCommandNumber.SIM_SET_POSE -> command.pose().ifPresent(this::place);
            case P2osCommandNumber.SIM_RESET -> {
                place(start);
                robot.resetOdometry();
            }
            case P2osCommandNumber.SIM_CTRL ->
                command.worldFile().ifPresent(file -> requests.loadWorld(robot.name(), file));
            case P2osCommandNumber.SIM_STAT -> simulator = Repetition.of(command.hasInteger() ? command.integer() : 1);
            case P2osCommandNumber.SIM_MESSAGE -> command.text().ifPresent(text -> requests.show(robot.name(), text));
            default -> {
                if (command.hasInteger()) {
                    perform(command.number(), command.integer());
                }
            }
        }
    }

    private void perform(int number, int argument) {
        switch (number) {
            case P2osCommandNumber.ENABLE -> robot.setMotors(argument != 0);
            case P2osCommandNumber.ENCODER -> encoders = Repetition.of(argument);
            case P2osCommandNumber.SONAR -> reports.setSonar(argument != 0);
            case P2osCommandNumber.BUMPSTALL -> stall.setBumpers((argument & 1) != 0, (argument & 2) != 0);
            case P2osCommandNumber.BATTEST -> robot.battery().setVolts(Math.max(0, Math.min(0xFF, argument)) / 10.0);
            case P2osCommandNumber.LASER, P2osCommandNumber.SIM_LRF_ENABLE -> laser.setMode(argument);
            case P2osCommandNumber.LASER_START, P2osCommandNumber.SIM_LRF_START -> laser.setStart(argument);
            case P2osCommandNumber.LASER_END, P2osCommandNumber.SIM_LRF_END -> laser.setEnd(argument);
            case P2osCommandNumber.LASER_STEP, P2osCommandNumber.SIM_LRF_STEP -> laser.setStep(argument);
            default -> motion.perform(number, argument);
        }
    }

    /** Moves the true pose, unless the robot executes an order by telephone. */
    private void place(Pose pose) {
        if (!robot.isUnderOrder()) {
            robot.brakeAtOnce();
            robot.place(pose.xMeters(), pose.yMeters(), Math.toRadians(pose.headingDegrees()));
        }
    }

    // ---- information packets -------------------------------------------------------------------------------------

    private void sendWhenDue() {
        long gap = nanos - sipNanos;
        boolean due = simulatedNanos - sipSimulatedNanos >= SIP_NANOS && gap >= MIN_GAP_NANOS;
        if (due || gap >= MAX_GAP_NANOS) {
            sendInformation();
        }
    }

    private void sendInformation() {
        boolean late = simulatedNanos - sipSimulatedNanos >= 2 * SIP_NANOS;
        sipSimulatedNanos =
                late || simulatedNanos - sipSimulatedNanos < SIP_NANOS ? simulatedNanos : sipSimulatedNanos + SIP_NANOS;
        sipNanos = nanos;
        output.send(reports.information(simulatedNanos));
        if (encoders != Repetition.NEVER) {
            encoders = encoders == Repetition.ALWAYS ? Repetition.ALWAYS : Repetition.NEVER;
            output.send(reports.encoders());
        }
        if (simulator != Repetition.NEVER) {
            simulator = simulator == Repetition.ALWAYS ? Repetition.ALWAYS : Repetition.NEVER;
            output.send(reports.simulator());
        }
        laser.scan().forEach(output::send);
    }

    /** Returns all sonars, sonar 0 first. */
    static List<Integer> allSonars() {
        return IntStream.range(0, SonarRing.COUNT).boxed().toList();
    }
}
