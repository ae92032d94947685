package simgsm.station.call;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;

/**
 * A second call besides the current one: waiting (TS 24.083, 1: confirmed with cause 17, alerted, and in U7 until the
 * first has ended or is held, or the caller hangs up), or held (TS 24.083, 2).
 */
final class SecondCall {
    /** @param received the transaction as in the messages received */
    record Party(TransactionIdentifier received, Optional<Msisdn> number, boolean isHeld) {}

    private final StationContext context;
    /** Runs when a held call has ended. */
    private final Runnable heldEnded;

    private final Consumer<TransactionIdentifier> over;

    private Optional<Party> party = Optional.empty();
    /** The transaction, as received, of a call that was cleared here and not yet released by the network. */
    private Optional<TransactionIdentifier> cleared = Optional.empty();

    /** @param over receives the transaction, as sent, of each call that has ended */
    SecondCall(StationContext context, Runnable heldEnded, Consumer<TransactionIdentifier> over) {
        this.context = context;
        this.heldEnded = heldEnded;
        this.over = over;
    }

    boolean isPresent() {
        return party.isPresent();
    }

    boolean isHeld() {
        return party.filter(Party::isHeld).isPresent();
    }

    boolean isWaiting() {
        return isPresent() && !isHeld();
    }

    boolean has(TransactionIdentifier transaction) {
        return party.isPresent() && party.get().received().equals(transaction)
                || cleared.equals(Optional.of(transaction));
    }

    /** Transaction as in the messages sent. */
    TransactionIdentifier transaction() {
        return party.orElseThrow().received().answered();
    }

    void offered(CallControl.Setup setup) {
        party = Optional.of(new Party(setup.transaction(), setup.calling(), false));
        TransactionIdentifier own = setup.transaction().answered();
        send(new CallControl.CallConfirmed(own, Optional.of(Cause.USER_BUSY)));
        send(new CallControl.Alerting(own));
        context.events().add(new StationEvent.CallWaits(setup.calling()));
    }

    /** Holds the call that was active. */
    void hold(Party active) {
        party = Optional.of(active);
    }

    /** Clears the call; a waiting one with cause "user busy" (TS 22.030, 6.5.5.1). @return false if there is none */
    boolean clear() {
        if (party.isEmpty()) {
            return false;
        }
        cleared = Optional.of(party.get().received());
        send(new CallControl.Disconnect(transaction(), isHeld() ? Cause.NORMAL_CALL_CLEARING : Cause.USER_BUSY));
        end(Cause.NORMAL_CALL_CLEARING);
        return true;
    }

    /** A message of the call's transaction has arrived. */
    void arrived(CallControl message) {
        TransactionIdentifier own = message.transaction().answered();
        if (message instanceof CallControl.StatusEnquiry) {
            sendStatus(own, Cause.RESPONSE_TO_STATUS_ENQUIRY);
        } else if (message instanceof CallControl.Disconnect disconnect) {
            send(new CallControl.Release(own, Optional.empty()));
            end(message.transaction(), disconnect.cause());
        } else if (message instanceof CallControl.Release release) {
            send(new CallControl.ReleaseComplete(own, Optional.empty()));
            end(message.transaction(), release.cause().orElse(Cause.NORMAL_UNSPECIFIED));
        } else if (message instanceof CallControl.ReleaseComplete || isStatusNull(message)) {
            end(message.transaction(), Cause.NORMAL_UNSPECIFIED);
        } else if (!(message instanceof CallControl.Status) && !(message instanceof CallControl.Setup)) {
            sendStatus(own, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    private static boolean isStatusNull(CallControl message) {
        return message instanceof CallControl.Status status && status.callState() == MobileCallState.NULL.code();
    }

    private void sendStatus(TransactionIdentifier own, Cause cause) {
        MobileCallState state = isHeld() ? MobileCallState.ACTIVE : MobileCallState.CALL_RECEIVED;
        send(new CallControl.Status(own, cause, state.code()));
    }

    private void send(CallControl message) {
        context.radio().send(message);
    }

    private void end(TransactionIdentifier transaction, Cause cause) {
        if (cleared.equals(Optional.of(transaction))) {
            cleared = Optional.empty();
        } else {
            end(cause);
        }
    }

    /** The call has ended: the far end has hung up, or the radio connection is lost. */
    void end(Cause cause) {
        Optional<Party> ended = party;
        party = Optional.empty();
        ended.ifPresent(call -> over.accept(call.received().answered()));
        if (ended.isPresent() && ended.get().isHeld()) {
            context.events().add(new StationEvent.HeldCallEnded(cause));
            heldEnded.run();
        } else if (ended.isPresent()) {
            context.events().add(new StationEvent.WaitingCallEnded());
        }
    }

    /** Removes the call, which becomes the current one. */
    Optional<Party> take() {
        Optional<Party> taken = party;
        party = Optional.empty();
        return taken;
    }
}
