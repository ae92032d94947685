package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;

/** What the handset tells, in the order of the console's events. Called on the owner thread. */
public interface HandsetListener {
    default void registered(Msisdn number) {}

    default void unregistered(Optional<RejectCause> cause) {}

    default void calling(Msisdn number) {}

    default void alerting() {}

    default void ringing(Optional<Msisdn> from) {}

    /** A second call waits; it rings when the first has ended. */
    default void waiting(Optional<Msisdn> from) {}

    /** Its caller has given up. */
    default void waitingOver() {}

    default void connected(Optional<Msisdn> peer) {}

    /** The last tone of these keys has left. @param keys as they were pressed, without blanks */
    default void sent(String keys) {}

    /** The network does not take keys as messages. @param keys those that have not left */
    default void keysRefused(String keys, Cause cause) {}

    /** A key was heard from the far end; decided while its tone sounds. */
    default void toneHeard(DtmfKey key) {}

    default void released(Cause cause) {}

    default void messageSent(Msisdn to, int parts, int id) {}

    default void messageFailed(Msisdn to, RpCause cause) {}

    default void messageDelivered(Msisdn to, int id) {}

    /** @param status TP-ST of the status report */
    default void messageUndelivered(Msisdn to, int id, int status) {}

    default void messageReceived(String from, String text) {}

    default void broadcastReceived(int channel, int pages, String text) {}
}
