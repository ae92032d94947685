package simrobot.control;

import simgsm.air.Msisdn;
import simgsm.dtmf.ToneTrace;
import simgsm.station.MobileStation;
import simgsm.station.StationSnapshot;
import simrobot.robot.SimulatedRobot;
import vericommand.VeriCommandSnapshot;

/** A robot that can be called: what windows and consoles hold of it. */
public final class TelephoneRobot {
    private final Msisdn number;
    private final RobotControl control;
    private final ModemLink link;

    TelephoneRobot(Msisdn number, RobotControl control, ModemLink link) {
        this.number = number;
        this.control = control;
        this.link = link;
    }

    public String name() {
        return control.robot().name();
    }

    public Msisdn number() {
        return number;
    }

    /** Sets who is told all that happens around this robot; before {@link SimRobot#start}. */
    public void listen(ControlListener listener) {
        control.listen(listener);
    }

    /** For the simulation's thread only. */
    public SimulatedRobot robot() {
        return control.robot();
    }

    MobileStation station() {
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

    /** The verifier's newest state; any thread may ask. */
    public VeriCommandSnapshot veriCommand() {
        return control.snapshot();
    }
}
