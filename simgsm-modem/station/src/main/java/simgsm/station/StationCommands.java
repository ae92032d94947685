package simgsm.station;

import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.octets.OctetString;
import simgsm.sms.ChannelList;
import simgsm.speech.SpeechCodec;
import simgsm.station.context.StationIdentity;

/** What the user of a station can do with it. All but {@link #identity} and {@link #snapshot} are called on the owner thread. */
public interface StationCommands {
    void powerOn();

    /** Ends a call with cause 16 and detaches. */
    void powerOff();

    /** Calls a number; without service the call waits 5 s for it. @return false if a call is under way or the station is off */
    boolean dial(Msisdn number);

    /** Answers the ringing call. @return false if there is none */
    boolean answer();

    /** Ends the call with cause 16; the caller of a ringing call receives 21, call rejected. @return false if there is none */
    boolean hangUp();

    /**
     * Queues a key that is signalled to the network, which plays its tone to the far end (START DTMF, STOP DTMF). Before
     * the call is active it waits.
     *
     * @param millis length of the tone, 70 at least
     */
    void signalKey(DtmfKey key, int millis);

    /** Queues a key that sounds until {@link #releaseKey}; a key that is held is released first. */
    void holdKey(DtmfKey key);

    /** Releases the key that is held, if there is one. */
    void releaseKey();

    /**
     * Queues a text, split into as many parts as it needs; a status report is requested. Without service it waits 40 s.
     *
     * @return the id of the message in {@link simgsm.station.context.StationEvent}s
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    int sendMessage(Msisdn to, String text);

    /**
     * Sends a USSD text: the reply if the network waits for one, else a request such as *100#, which begins a dialogue;
     * a code of a supplementary service such as *#21# is sent as that.
     *
     * @return false if a dialogue is under way and the network has not asked, or the station is off
     * @throws IllegalArgumentException for an empty text, and for more than 182 characters (80 outside the GSM alphabet)
     */
    boolean sendUssd(String text);

    /** Ends the USSD dialogue. @return false if there is none */
    boolean endUssd();

    /**
     * Queues a transfer unit as it is; only its reference is set here, and TP-RD when it is sent again. Otherwise as
     * {@link #sendMessage}.
     *
     * @param tpdu SUBMIT or COMMAND (TS 23.040, 9.2.2), 2 to 232 octets
     * @param to its receiver, for the status report
     */
    int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter);

    /** Rejects the waiting call with cause 17, or ends the held one. @return false if there is neither */
    boolean rejectWaiting();

    /**
     * Holds the active call; then the waiting call is answered, or the held one is active again. Without an active call the
     * held one is.
     *
     * @return false if there is no such call, or the network has still to answer
     */
    boolean hold();

    /**
     * Whether there is room for received messages. Without room the network is refused (RP cause 22) and keeps them; once
     * there is room again it is notified (RP-SMMA).
     */
    void setMemoryAvailable(boolean available);

    /** Discards broadcasts on other channels; at first all channels are received. */
    void setChannels(ChannelList channels);

    /** Codes speech so from the next call on. */
    void setCodec(SpeechCodec.Kind codec);

    /** What SIM and equipment hold. */
    StationIdentity identity();

    /** The current state; may be called from any thread. */
    StationSnapshot snapshot();
}
