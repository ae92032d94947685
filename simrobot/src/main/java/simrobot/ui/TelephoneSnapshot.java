package simrobot.ui;

import java.util.Objects;
import simgsm.dtmf.ToneTrace;
import simgsm.station.MobileCallState;
import simgsm.station.StationSnapshot;
import vericommand.VeriCommandSnapshot;

/**
 * The telephone's side of one robot: its modem, what the modem hears, and what VeriCommand makes of it.
 *
 * @param robot the robot's name
 * @param number the modem's own number
 * @param tones the reply tones that have left in the present or last call, the newest last
 * @param audible whether a sound device plays
 */
public record TelephoneSnapshot(
        String robot,
        String number,
        StationSnapshot modem,
        ToneTrace heard,
        VeriCommandSnapshot orders,
        String tones,
        boolean audible) {
    public TelephoneSnapshot {
        Objects.requireNonNull(robot);
        Objects.requireNonNull(number);
        Objects.requireNonNull(modem);
        Objects.requireNonNull(heard);
        Objects.requireNonNull(orders);
        Objects.requireNonNull(tones);
    }

    /** Whether a call is up or being set up. */
    public boolean isInCall() {
        return modem.callState() != MobileCallState.NULL;
    }

    /** Whether somebody commands this robot right now. */
    public boolean isBusy() {
        return isInCall() || orders.underWay();
    }
}
