package simgsm.station;

import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;

/**
 * A second call that the network offers while the first is under way (TS 24.083, 1): confirmed with cause 17, alerted, and
 * kept in U7 until the first has ended and it rings like any other, or until its caller has had enough.
 */
final class WaitingCall {
    private final StationParts parts;
    /** As it is received; null while nobody waits. */
    private TransactionIdentifier received;

    private Optional<Msisdn> caller = Optional.empty();

    WaitingCall(StationParts parts) {
        this.parts = parts;
    }

    /** What is left of it for the call that it becomes. */
    record Offer(TransactionIdentifier received, Optional<Msisdn> caller) {}

    boolean isThere() {
        return received != null;
    }

    boolean has(TransactionIdentifier transaction) {
        return transaction.equals(received);
    }

    void offered(CallControl.Setup setup) {
        received = setup.transaction();
        caller = setup.calling();
        send(new CallControl.CallConfirmed(received.answered(), Optional.of(Cause.USER_BUSY)));
        send(new CallControl.Alerting(received.answered()));
        Optional<Msisdn> who = caller;
        parts.notifications().add(listener -> listener.waiting(who));
    }

    /** A message of its transaction has come. */
    void arrived(CallControl message) {
        TransactionIdentifier ours = received.answered();
        if (message instanceof CallControl.StatusEnquiry) {
            sendStatus(Cause.RESPONSE_TO_STATUS_ENQUIRY);
        } else if (message instanceof CallControl.Disconnect) {
            send(new CallControl.Release(ours, Optional.empty()));
            over();
        } else if (message instanceof CallControl.Release) {
            send(new CallControl.ReleaseComplete(ours, Optional.empty()));
            over();
        } else if (message instanceof CallControl.ReleaseComplete || isStatusOfNone(message)) {
            over();
        } else if (!(message instanceof CallControl.Status) && !(message instanceof CallControl.Setup)) {
            sendStatus(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    private static boolean isStatusOfNone(CallControl message) {
        return message instanceof CallControl.Status status && status.callState() == MobileCallState.NULL.code();
    }

    private void sendStatus(Cause cause) {
        send(new CallControl.Status(received.answered(), cause, MobileCallState.CALL_RECEIVED.code()));
    }

    private void send(CallControl message) {
        parts.radio().send(message);
    }

    /** Its caller has given up, or the radio is lost. */
    void over() {
        if (isThere()) {
            forget();
            parts.notifications().add(StationListener::waitingOver);
        }
    }

    /** The first call has ended: this one is the call now. */
    Optional<Offer> take() {
        Optional<Offer> offer = Optional.ofNullable(received).map(transaction -> new Offer(transaction, caller));
        forget();
        return offer;
    }

    private void forget() {
        received = null;
        caller = Optional.empty();
    }
}
