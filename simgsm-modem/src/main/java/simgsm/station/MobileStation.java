package simgsm.station;

import simgsm.air.Cause;
import simgsm.air.IpaFrame;
import simgsm.air.Msisdn;

/**
 * A mobile station as a deterministic core: frames, acts and time in; frames and {@link StationListener} calls out. It has
 * no thread, clock or socket of its own. One owner calls everything except {@link #snapshot}; acts happen at the time that
 * the owner told last.
 */
public final class MobileStation {
    /** {@link #nextDeadlineNanos} of a station that waits for nothing. */
    public static final long NO_DEADLINE = Long.MAX_VALUE;

    /** A station that is switched on and has no link yet. */
    public MobileStation(StationIdentity identity, Sim sim, SpeechSource speech, StationListener listener) {
        throw new UnsupportedOperationException();
    }

    public StationIdentity identity() {
        throw new UnsupportedOperationException();
    }

    /** A connection to the centre is there. */
    public void linkUp(Uplink uplink, long nowNanos) {
        throw new UnsupportedOperationException();
    }

    /** The connection is lost, or could not be made. */
    public void linkDown(long nowNanos) {
        throw new UnsupportedOperationException();
    }

    public void frameArrived(IpaFrame frame, long nowNanos) {
        throw new UnsupportedOperationException();
    }

    /** Does what is due; calling it early or often is harmless. */
    public void timePassed(long nowNanos) {
        throw new UnsupportedOperationException();
    }

    /** When {@link #timePassed} is to be called next, or {@link #NO_DEADLINE}. */
    public long nextDeadlineNanos() {
        throw new UnsupportedOperationException();
    }

    public void powerOn() {
        throw new UnsupportedOperationException();
    }

    /** Ends a call with cause 16, detaches and says unregistered. */
    public void powerOff() {
        throw new UnsupportedOperationException();
    }

    /** Calls a number. @return false if a call is already under way or the station is off, and nothing happens */
    public boolean dial(Msisdn number) {
        throw new UnsupportedOperationException();
    }

    /** Takes the ringing call. @return false if none rings */
    public boolean answer() {
        throw new UnsupportedOperationException();
    }

    /** Ends the call with cause 16. @return false if there is none */
    public boolean hangUp() {
        return clear(Cause.NORMAL_CALL_CLEARING);
    }

    /** Ends the call with this cause. @return false if there is none */
    public boolean clear(Cause cause) {
        throw new UnsupportedOperationException();
    }

    /**
     * Queues a text, cut into as many parts as it needs; a status report is asked for.
     *
     * @return the message reference of the first part, 0 to 255
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    public int sendMessage(Msisdn to, String text) {
        throw new UnsupportedOperationException();
    }

    /** The newest state; any thread may ask. */
    public StationSnapshot snapshot() {
        throw new UnsupportedOperationException();
    }
}
