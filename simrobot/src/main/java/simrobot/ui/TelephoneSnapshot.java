package simrobot.ui;

import simgsm.dtmf.ToneTrace;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import vericommand.VeriCommandSnapshot;

/**
 * A robot's modem, the tone trace of what it hears, and VeriCommand's state.
 *
 * @param robot the robot's name
 * @param number the modem's own number
 * @param tones the reply tones sent in the current or last call, the newest last
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
    /** Whether a call is active or being set up. */
    public boolean isInCall() {
        return modem.callState() != MobileCallState.NULL;
    }

    /** Whether the robot is in a call or executes an order. */
    public boolean isBusy() {
        return isInCall() || orders.underWay();
    }
}
