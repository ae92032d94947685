package simgsm.modem.at.command;

import java.util.List;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.octets.OctetString;
import simgsm.sim.SimPhoneBook;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;

/** The terminal that is commanded: a phone or M2. All methods belong to the thread that owns its station. */
public interface AtTerminal {
    /** The model's name, such as M1. */
    String model();

    StationIdentity identity();

    StationSnapshot snapshot();

    /** The SIM's phone book. */
    SimPhoneBook phoneBook();

    /** @return false if a call is under way or the terminal is off */
    boolean dial(Msisdn number);

    /** Answers the ringing call. @return false if there is none */
    boolean answer();

    /** Ends the call, or rejects the ringing one. @return false if there is none */
    boolean hangUp();

    /** Rejects the waiting call, or ends the held one. @return false if there is neither */
    boolean rejectWaiting();

    /** As in {@link simgsm.station.StationCommands#hold}. */
    default boolean hold() {
        return false;
    }

    /** Whether a second call may wait. */
    boolean hasCallWaiting();

    /**
     * Sends keys in the active call.
     *
     * @param toneMillis length of each tone, 70 at least
     * @param sent runs when the last has been sent; never if the call ends before
     */
    void sendKeys(List<DtmfKey> keys, int toneMillis, Runnable sent);

    /** Switches the station on, or detaches it. */
    void setPower(boolean on);

    /** As in {@link simgsm.station.StationCommands#sendUssd}. */
    boolean sendUssd(String text);

    /** Ends the USSD dialogue. @return false if there is none */
    boolean endUssd();

    /**
     * Submits a transfer unit; its message reference is set by the station.
     *
     * @param tpdu SUBMIT or COMMAND (TS 23.040), at least two octets
     * @return the message's id in {@link StationEvent.OfSubmittedMessage}
     */
    int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter);

    /** Whether there is room for received messages; see {@link simgsm.station.StationCommands#setMemoryAvailable}. */
    void setMemoryAvailable(boolean available);

    /** Receives the station's events before the commands do. */
    default void accept(StationEvent event) {}
}
