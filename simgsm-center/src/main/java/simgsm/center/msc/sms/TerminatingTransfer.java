package simgsm.center.msc.sms;

import java.util.function.Consumer;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.msc.link.PagedTransaction;
import simgsm.center.msc.sms.TerminatingTransferTable.TerminatingAction;
import simgsm.center.msc.sms.TerminatingTransferTable.TerminatingEvent;
import simgsm.center.msc.sms.TerminatingTransferTable.TerminatingState;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.octets.OctetString;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;

/** One short message to a mobile: {@link TerminatingTransferTable} driven by paging, the mobile and timers. */
final class TerminatingTransfer implements PagedTransaction {
    private final Link link;
    private final TransactionIdentifier transaction;
    private final int reference;
    private final Consumer<DeliveryOutcome> ended;
    private final CpRepeater data;
    private final StateMachine<TerminatingState, TerminatingEvent, TerminatingAction> machine;
    private Timer answerTimer;

    /** @param reference RP message reference, 0 to 255 */
    TerminatingTransfer(
            Link link,
            TransactionIdentifier transaction,
            int reference,
            OctetString tpdu,
            Consumer<DeliveryOutcome> ended) {
        this.link = link;
        this.transaction = transaction;
        this.reference = reference;
        this.ended = ended;
        this.machine = new StateMachine<>(TerminatingTransferTable.ROWS, link, this::perform);
        this.data = new CpRepeater(
                link,
                () -> machine.fire(TerminatingEvent.TC1_EXPIRED),
                () -> machine.fire(TerminatingEvent.TC1_EXPIRED_AT_LAST));
        data.prepare(new ShortMessageControl.CpData(
                transaction, new RelayMessage.RpData(reference, ShortMessageCenter.ADDRESS, tpdu)));
    }

    TransactionIdentifier transaction() {
        return transaction;
    }

    boolean needsRadio() {
        return machine.state() != TerminatingState.MM_CONNECTION_PENDING;
    }

    @Override
    public void radioConnected() {
        machine.fire(TerminatingEvent.RADIO_CONNECTED);
    }

    @Override
    public void pagingFailed() {
        machine.fire(TerminatingEvent.PAGING_FAILED);
    }

    void radioLost() {
        machine.fire(TerminatingEvent.RADIO_LOST);
    }

    void receive(ShortMessageControl message) {
        machine.fire(
                message instanceof ShortMessageControl.CpData answer
                        ? eventOf(answer.relay())
                        : message instanceof ShortMessageControl.CpAck
                                ? TerminatingEvent.CP_ACK_RECEIVED
                                : TerminatingEvent.CP_ERROR_RECEIVED);
    }

    private TerminatingEvent eventOf(RelayMessage relay) {
        if (relay.reference() == reference && relay instanceof RelayMessage.RpAck) {
            return TerminatingEvent.RP_ACK_RECEIVED;
        }
        if (relay.reference() == reference && relay instanceof RelayMessage.RpError error) {
            return error.cause() == RpCause.MEMORY_CAPACITY_EXCEEDED
                    ? TerminatingEvent.MEMORY_EXCEEDED_RECEIVED
                    : TerminatingEvent.RP_ERROR_RECEIVED;
        }
        return TerminatingEvent.OTHER_CP_DATA_RECEIVED;
    }

    private void perform(TerminatingAction action) {
        switch (action) {
            case START_TR1N ->
                answerTimer = link.timers()
                        .start(NetworkTimer.TR1N.nanos(), () -> machine.fire(TerminatingEvent.TR1N_EXPIRED));
            case SEND_CP_DATA -> data.send();
            case STOP_TC1 -> data.stop();
            case SEND_CP_ACK -> link.send(new ShortMessageControl.CpAck(transaction));
            case END_DELIVERED -> end(DeliveryOutcome.DELIVERED);
            case END_MEMORY_FULL -> end(DeliveryOutcome.MEMORY_FULL);
            case END_REFUSED -> end(DeliveryOutcome.REFUSED);
            case END_ABSENT -> end(DeliveryOutcome.ABSENT);
            case END_FAILED -> end(DeliveryOutcome.FAILED);
        }
    }

    private void end(DeliveryOutcome outcome) {
        data.stop();
        link.timers().cancel(answerTimer);
        link.paging().cancel(this);
        ended.accept(outcome);
    }
}
