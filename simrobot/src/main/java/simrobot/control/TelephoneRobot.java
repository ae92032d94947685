package simrobot.control;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.modem.AnsweringModem;
import simgsm.modem.Modem;
import simgsm.modem.ModemOptions;
import simgsm.scope.ToneTrace;
import simgsm.station.MobileStation;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simgsm.tone.ToneExperiment;
import simrobot.robot.Pioneer;
import simrobot.robot.Placement;
import simrobot.robot.SimulatedRobot;
import vericommand.OrderReport;
import vericommand.VeriCommandSettings;
import vericommand.VeriCommandSnapshot;

/** A robot with a modem and a verifier, as windows and consoles use it. */
public final class TelephoneRobot {
    private final Msisdn number;
    private final RobotControl control;
    private final ModemLink<?> link;

    /** Joins a robot to a verifier and to M2 without a link; the caller supplies the station's time and link. */
    public TelephoneRobot(
            Pioneer robot,
            StationIdentity identity,
            Sim sim,
            ModemOptions options,
            VeriCommandSettings settings,
            ControlThreads drivers) {
        this(
                robot,
                identity.number(),
                (admission, listener) -> new Modem(identity, sim, options, admission, listener),
                settings,
                drivers);
    }

    /** Joins a robot to a verifier and to any modem; the caller supplies the modem's time and line. */
    public <M extends AnsweringModem> TelephoneRobot(
            Pioneer robot,
            Msisdn number,
            AnsweringModem.Maker<M> maker,
            VeriCommandSettings settings,
            ControlThreads drivers) {
        this.number = number;
        link = new ModemLink<>(maker, drivers);
        control = new RobotControl(robot, settings, link, drivers.clockNanos());
        link.serve(control);
    }

    public String name() {
        return control.robot().name();
    }

    public Msisdn number() {
        return number;
    }

    /** Adds a listener for all events around this robot; see {@link SimRobot#onAdded}. */
    public void listen(Consumer<RobotEvent> listener) {
        control.listen(listener);
    }

    /** A Pioneer program sent a text for the operator. For the simulation's thread only. */
    public void clientMessage(String text) {
        control.tell(new RobotEvent.ClientMessage(text));
    }

    /**
     * Submits an order of a program, such as {@code ** #**20 **}. For the simulation's thread only.
     *
     * @param operator owner of the program's key
     * @param follower receives the order's progress on the simulation's thread: first before this returns, last at the
     *     order's end
     */
    public void order(String operator, String keys, Consumer<OrderReport> follower) {
        control.order(operator, keys, follower);
    }

    /** For the simulation's thread only. */
    public Pioneer robot() {
        return control.robot();
    }

    /** Puts the robot there by hand, and tells of it. For the simulation's thread only. */
    public Placement place(double xMeters, double yMeters, double headingRadians) {
        Placement placement = robot().place(xMeters, yMeters, headingRadians);
        if (placement == Placement.DONE) {
            control.tell(new RobotEvent.Placed(robot().pose()));
        }
        return placement;
    }

    /** Returns the robot if it is simulated. For the simulation's thread only. */
    public Optional<SimulatedRobot> simulated() {
        return robot() instanceof SimulatedRobot simulated ? Optional.of(simulated) : Optional.empty();
    }

    /** M2; empty with a real modem. For the thread that owns it. */
    public Optional<Modem> m2() {
        return link.modem() instanceof Modem m2 ? Optional.of(m2) : Optional.empty();
    }

    /** M2's station. For the thread that owns it. */
    public MobileStation station() {
        return m2().orElseThrow().station();
    }

    /** Returns the modem's newest state; callable on any thread. */
    public StationSnapshot modem() {
        return link.modem().snapshot();
    }

    /** Returns the modem's state in words, as the console's {@code modem} answers; callable on any thread. */
    public RobotEvent.ModemChanged modemState() {
        return link.state();
    }

    /** Returns the trace of the caller's key tones; callable on any thread. */
    public ToneTrace heard() {
        return link.trace();
    }

    /** Sets the experiment applied to {@link #heard} only, not to the modem's input. Callable on any thread. */
    public void tryOut(ToneExperiment experiment) {
        link.tryOut(experiment);
    }

    /** Returns the verifier's newest state; callable on any thread. */
    public VeriCommandSnapshot veriCommand() {
        return control.snapshot();
    }
}
