package simrobot.control;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.dtmf.ToneExperiment;
import simgsm.dtmf.ToneTrace;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simrobot.robot.Pioneer;
import simrobot.robot.SimulatedRobot;
import vericommand.VeriCommandSettings;
import vericommand.VeriCommandSnapshot;

/** A robot that can be called: what windows and consoles hold of it. */
public final class TelephoneRobot {
    private final Msisdn number;
    private final RobotControl control;
    private final ModemLink link;

    /** A robot joined to a verifier and to a modem that has no link yet; who drives it gives the station time and a link. */
    public TelephoneRobot(
            Pioneer robot,
            StationIdentity identity,
            Sim sim,
            StationOptions options,
            VeriCommandSettings settings,
            ControlThreads drivers) {
        number = identity.number();
        link = new ModemLink(identity, sim, options, drivers);
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

    /** For the simulation's thread only. */
    public Pioneer robot() {
        return control.robot();
    }

    /** The same, if it is a simulated one. */
    public Optional<SimulatedRobot> simulated() {
        return robot() instanceof SimulatedRobot simulated ? Optional.of(simulated) : Optional.empty();
    }

    /** For the thread that owns the station. */
    public MobileStation station() {
        return link.modem().station();
    }

    /** The modem's newest state; any thread may ask. */
    public StationSnapshot modem() {
        return station().snapshot();
    }

    /** The sound of the caller's keys; any thread may ask. */
    public ToneTrace heard() {
        return link.trace();
    }

    /** What {@link #heard} is to make of the sound; the modem hears the call as it is. Any thread may ask. */
    public void tryOut(ToneExperiment experiment) {
        link.tryOut(experiment);
    }

    /** The verifier's newest state; any thread may ask. */
    public VeriCommandSnapshot veriCommand() {
        return control.snapshot();
    }
}
