package simgsm.station;

import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.octets.OctetString;
import simgsm.sim.PinLock;
import simgsm.sms.ChannelList;
import simgsm.speech.SpeechCodec;
import simgsm.station.context.StationIdentity;

/**
 * A user's commands to a station. All but {@link #identity} and {@link #snapshot} are called on the owner thread.
 */
public interface StationCommands {
    void powerOn();

    /** Ends a call with cause 16 and detaches. */
    void powerOff();

    /** Gives the card a command of its user. @return its answer; REFUSED if the station is off */
    PinLock.Result useCard(Function<PinLock, PinLock.Result> command);

    /**
     * Calls a number; without service the call waits 5 s.
     *
     * @return false if a call is under way, the station is off, or the card is locked and this is no emergency number
     */
    boolean dial(Msisdn number);

    /** Hides the own number in the next dialled call, or shows it (CLIR, TS 24.081, 2). */
    void hideNumber(boolean hides);

    /** Answers the ringing call. @return false if there is none */
    boolean answer();

    /** Ends the call with cause 16; the caller of a ringing call receives 21, call rejected. @return false if there is none */
    boolean hangUp();

    /**
     * Queues a key signalled to the network, which plays its tone to the far end (START DTMF, STOP DTMF). It waits
     * until the call is active.
     *
     * @param millis length of the tone, 70 at least
     */
    void signalKey(DtmfKey key, int millis);

    /** Queues a key that sounds until {@link #releaseKey}; a held key is released first. */
    void holdKey(DtmfKey key);

    /** Releases the held key, if any. */
    void releaseKey();

    /**
     * Queues a text, split into as many parts as it needs; a status report is requested. Without service it waits 40 s.
     *
     * @return the id of the message in {@link simgsm.station.context.StationEvent}s
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    int sendMessage(Msisdn to, String text);

    /**
     * Sends a USSD text: the reply if the network waits for one, else a request such as *100#, which begins a
     * dialogue; a code such as *#21# is sent as a supplementary service.
     *
     * @return false if a dialogue is under way and the network has not asked, or the station is off
     * @throws IllegalArgumentException for an empty text, and for more than 182 characters (80 outside the GSM
     *     alphabet)
     */
    boolean sendUssd(String text);

    /** Ends the USSD dialogue. @return false if there is none */
    boolean endUssd();

    /**
     * Queues a transfer unit unchanged, except for its reference, and TP-RD of a repetition. Otherwise as {@link
     * #sendMessage}.
     *
     * @param tpdu SUBMIT or COMMAND (TS 23.040, 9.2.2), 2 to 232 octets
     * @param to receiver, for the status report
     */
    int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter);

    /** Rejects the waiting call with cause 17, or ends the held one. @return false if there is neither */
    boolean rejectWaiting();

    /**
     * Holds the active call; then the waiting call is answered, or the held one retrieved. Without an active call the
     * held one is retrieved.
     *
     * @return false if there is no such call, or the network has still to answer
     */
    boolean hold();

    /**
     * Sets if there is room for received messages. Without room the network is refused (RP cause 22) and keeps them;
     * it is notified once there is room again (RP-SMMA).
     */
    void setMemoryAvailable(boolean available);

    /** Discards broadcasts on other channels; initially all channels are received. */
    void setChannels(ChannelList channels);

    /** Sets the codec of speech from the next call on. */
    void setCodec(SpeechCodec.Kind codec);

    /** Data of SIM and equipment. */
    StationIdentity identity();

    /** The current state; may be called from any thread. */
    StationSnapshot snapshot();
}
