package simgsm.station;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;

/**
 * What a station tells its user. Called by the owner thread once the station's state is settled, so every act of the
 * station may be called from within.
 */
public interface StationListener {
    default void registered(Msisdn number) {}

    /** Told at each loss of service and at each new reason, not at every further try. @param cause if the network refused */
    default void unregistered(Optional<RejectCause> cause) {}

    /** One's own call begins. */
    default void calling(Msisdn number) {}

    /** The called party's phone rings. */
    default void alerting() {}

    /** @param from empty if the network does not say */
    default void ringing(Optional<Msisdn> from) {}

    /** Whether a second call may wait while one is under way; else its caller hears that the user is busy. */
    default boolean takesWaitingCalls() {
        return false;
    }

    /** A second call waits; when the first has ended it is told as {@link #ringing}. */
    default void waiting(Optional<Msisdn> from) {}

    /** The caller that waited has given up. */
    default void waitingOver() {}

    default void connected(Optional<Msisdn> peer) {}

    /** Exactly once a call, at the first clearing message sent or received. One's own hang-up is cause 16. */
    default void released(Cause cause) {}

    /**
     * Whether the network itself lets the user hear how the call goes (TS 24.008, 5.5.1 and 5.4.4.1.1.1). While it does,
     * {@link #speechReceived} brings its tones, before the call is connected or after it was released, and the user's
     * equipment makes none of its own.
     */
    default void networkTones(boolean heard) {}

    /** The far end's next 20 ms: 160 samples, 8 kHz, 16 bit. Frames that were lost come as silence of their length. */
    default void speechReceived(short[] samples) {}

    /** A signalled key: the network lets it sound from now on. */
    default void keySounds(DtmfKey key) {}

    /** A signalled key: the network has been asked to end its tone. */
    default void keyLetGo(DtmfKey key) {}

    /** A signalled key: its tone is over. */
    default void keyLeft(DtmfKey key) {}

    /** The network has refused a signalled key, or has not answered; those that waited behind it are dropped. */
    default void keysRefused(Cause cause) {}

    /** The network has acknowledged all parts. @param id what {@link MobileStation#sendMessage} returned */
    default void messageSent(int id, Msisdn to, int parts) {}

    default void messageFailed(int id, Msisdn to, RpCause cause) {}

    /** A whole message, its parts joined and duplicates dropped. @param from a number, or a name where the sender has one */
    default void messageReceived(String from, String text) {}

    /** The status report of the last part has come. */
    default void messageDelivered(int id, Msisdn to) {}

    /** The status report says that it will not be delivered. @param status TP-ST, see {@link simgsm.sms.DeliveryStatus} */
    default void messageUndelivered(int id, Msisdn to, int status) {}

    default void broadcastReceived(int channel, int pages, String text) {}

    /** Half a minute has passed since {@link MobileStation#remind}. */
    default void reminded() {}

    /** The snapshot has changed. */
    default void stateChanged(StationSnapshot snapshot) {}
}
