package simgsm.modem.at.command;

import java.util.List;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.sim.SimPhoneBook;
import simgsm.station.MobileStation;
import simgsm.station.context.StationEvent;

/** The commanded terminal: a phone or M2. All methods belong to the thread that owns its station. */
public interface AtTerminal {
    /** The model's name, such as M1. */
    String model();

    MobileStation station();

    /** The SIM's phone book. */
    SimPhoneBook phoneBook();

    /** @return false if a call is under way or the terminal is off */
    default boolean dial(Msisdn number) {
        return station().dial(number);
    }

    /** Answers the ringing call. @return false if there is none */
    boolean answer();

    /** Ends the call, or rejects the ringing one. @return false if there is none */
    default boolean hangUp() {
        return station().hangUp();
    }

    /** Rejects the waiting call, or ends the held one. @return false if there is neither */
    default boolean rejectWaiting() {
        return station().rejectWaiting();
    }

    /** As in {@link simgsm.station.StationCommands#hold}. */
    default boolean hold() {
        return false;
    }

    /** True if a second call may wait. */
    boolean hasCallWaiting();

    /**
     * Sends keys in the active call.
     *
     * @param toneMillis length of each tone, 70 at least
     * @param sent runs after the last tone; never if the call ends before
     */
    void sendKeys(List<DtmfKey> keys, int toneMillis, Runnable sent);

    /** Switches the station on, or detaches it. */
    void setPower(boolean on);

    /** As in {@link simgsm.station.StationCommands#sendUssd}. */
    default boolean sendUssd(String text) {
        return station().sendUssd(text);
    }

    /**
     * Sets if there is room for received messages; see {@link simgsm.station.StationCommands#setMemoryAvailable}.
     */
    default void setMemoryAvailable(boolean available) {
        station().setMemoryAvailable(available);
    }

    /** Receives the station's events before the commands do. */
    default void accept(StationEvent event) {}
}
