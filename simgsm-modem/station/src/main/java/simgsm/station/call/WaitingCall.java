package simgsm.station.call;

import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;

/**
 * A second call, offered while the first is active (TS 24.083, 1): confirmed with cause 17, alerted, and kept in U7 until
 * the first has ended or the caller hangs up.
 */
final class WaitingCall {
    /** @param received the transaction as in the messages received */
    record WaitingOffer(TransactionIdentifier received, Optional<Msisdn> caller) {}

    private final StationContext context;
    private Optional<WaitingOffer> offer = Optional.empty();
    /** The transaction, as received, of a rejected call that the network has not released yet. */
    private Optional<TransactionIdentifier> rejected = Optional.empty();

    WaitingCall(StationContext context) {
        this.context = context;
    }

    boolean isPresent() {
        return offer.isPresent();
    }

    boolean has(TransactionIdentifier transaction) {
        return offer.isPresent() && offer.get().received().equals(transaction)
                || rejected.equals(Optional.of(transaction));
    }

    void offered(CallControl.Setup setup) {
        offer = Optional.of(new WaitingOffer(setup.transaction(), setup.calling()));
        TransactionIdentifier own = setup.transaction().answered();
        send(new CallControl.CallConfirmed(own, Optional.of(Cause.USER_BUSY)));
        send(new CallControl.Alerting(own));
        context.events().add(new StationEvent.CallWaits(setup.calling()));
    }

    /** Rejects the call: user determined user busy (TS 22.030, 6.5.5.1). @return false if none waits */
    boolean reject() {
        if (offer.isEmpty()) {
            return false;
        }
        rejected = Optional.of(offer.get().received());
        send(new CallControl.Disconnect(offer.get().received().answered(), Cause.USER_BUSY));
        end();
        return true;
    }

    /** A message of the waiting call's transaction has arrived. */
    void arrived(CallControl message) {
        TransactionIdentifier own = message.transaction().answered();
        if (message instanceof CallControl.StatusEnquiry) {
            sendStatus(own, Cause.RESPONSE_TO_STATUS_ENQUIRY);
        } else if (message instanceof CallControl.Disconnect) {
            send(new CallControl.Release(own, Optional.empty()));
            end(message.transaction());
        } else if (message instanceof CallControl.Release) {
            send(new CallControl.ReleaseComplete(own, Optional.empty()));
            end(message.transaction());
        } else if (message instanceof CallControl.ReleaseComplete || isStatusNull(message)) {
            end(message.transaction());
        } else if (!(message instanceof CallControl.Status) && !(message instanceof CallControl.Setup)) {
            sendStatus(own, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    private static boolean isStatusNull(CallControl message) {
        return message instanceof CallControl.Status status && status.callState() == MobileCallState.NULL.code();
    }

    private void sendStatus(TransactionIdentifier own, Cause cause) {
        send(new CallControl.Status(own, cause, MobileCallState.CALL_RECEIVED.code()));
    }

    private void send(CallControl message) {
        context.radio().send(message);
    }

    private void end(TransactionIdentifier transaction) {
        if (rejected.equals(Optional.of(transaction))) {
            rejected = Optional.empty();
        } else {
            end();
        }
    }

    /** The caller has hung up, or the radio connection is lost. */
    void end() {
        if (offer.isPresent()) {
            offer = Optional.empty();
            context.events().add(new StationEvent.WaitingCallEnded());
        }
    }

    /** Removes the waiting call: it becomes the call. */
    Optional<WaitingOffer> take() {
        Optional<WaitingOffer> taken = offer;
        offer = Optional.empty();
        return taken;
    }
}
