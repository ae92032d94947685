package simrobot.ui;

import simgsm.scope.ToneTrace;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import vericommand.VeriCommandSnapshot;

/**
 * A robot's modem, the tone trace of its input, and VeriCommand's state.
 *
 * @param robot the robot's name
 * @param number the modem's number
 * @param tones the reply tones sent in the current or last call, newest last
 * @param words said after the newest of them; empty if there are none
 * @param audible true if a sound device plays
 */
public record TelephoneSnapshot(
        String robot,
        String number,
        StationSnapshot modem,
        ToneTrace heard,
        VeriCommandSnapshot orders,
        String tones,
        String words,
        boolean audible) {
    /** True if a call is active or being set up. */
    public boolean isInCall() {
        return modem.callState() != MobileCallState.NULL;
    }

    /** True if the robot is in a call or executes an order. */
    public boolean isBusy() {
        return isInCall() || orders.underWay();
    }
}
