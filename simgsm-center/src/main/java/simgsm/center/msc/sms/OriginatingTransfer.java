package simgsm.center.msc.sms;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.sms.OriginatingTransferTable.OriginatingAction;
import simgsm.center.msc.sms.OriginatingTransferTable.OriginatingEvent;
import simgsm.center.msc.sms.OriginatingTransferTable.OriginatingState;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.state.StateMachine;

/** One short message from a mobile: {@link OriginatingTransferTable} driven by the mobile and the short message centre. */
final class OriginatingTransfer {
    private final Link link;
    private final TransactionIdentifier transaction;
    private final ShortMessageControl first;
    private final boolean isRepeated;
    private final ShortMessageCenter center;
    private final Consumer<OriginatingTransfer> ended;
    private final CpRepeater answer;
    private final StateMachine<OriginatingState, OriginatingEvent, OriginatingAction> machine;
    private boolean isConfirmed;

    /**
     * @param first the message that begins the transaction
     * @param isRepeated true if the mobile may repeat a message of a transaction that has ended without its
     * acknowledgement
     */
    OriginatingTransfer(
            Link link,
            ShortMessageControl first,
            boolean isRepeated,
            ShortMessageCenter center,
            Consumer<OriginatingTransfer> ended) {
        this.link = link;
        this.transaction = first.transaction().answered();
        this.first = first;
        this.isRepeated = isRepeated;
        this.center = center;
        this.ended = ended;
        this.machine = new StateMachine<>(OriginatingTransferTable.ROWS, link, this::perform);
        this.answer = new CpRepeater(
                link,
                () -> machine.fire(OriginatingEvent.TC1_EXPIRED),
                () -> machine.fire(OriginatingEvent.TC1_EXPIRED_AT_LAST));
    }

    TransactionIdentifier transaction() {
        return transaction;
    }

    ShortMessageControl first() {
        return first;
    }

    /** True if the mobile has acknowledged the answer. */
    boolean isConfirmed() {
        return isConfirmed;
    }

    void receive(ShortMessageControl message) {
        machine.fire(
                message instanceof ShortMessageControl.CpData
                        ? OriginatingEvent.CP_DATA_RECEIVED
                        : message instanceof ShortMessageControl.CpAck
                                ? OriginatingEvent.CP_ACK_RECEIVED
                                : OriginatingEvent.CP_ERROR_RECEIVED);
    }

    void radioLost() {
        machine.fire(OriginatingEvent.RADIO_LOST);
    }

    private void perform(OriginatingAction action) {
        switch (action) {
            case SEND_CP_ACK -> link.send(new ShortMessageControl.CpAck(transaction));
            case SUBMIT -> submit(((ShortMessageControl.CpData) first).relay());
            case SEND_CP_DATA -> answer.send();
            case CONFIRM -> isConfirmed = true;
            case END -> {
                answer.stop();
                ended.accept(this);
            }
        }
    }

    private void submit(RelayMessage message) {
        int reference = message.reference();
        if (message instanceof RelayMessage.RpData && !link.rateLimits().admitMessage()) {
            answer(reference, Optional.of(RpCause.CONGESTION));
        } else if (message instanceof RelayMessage.RpData data) {
            center.submit(link.subscriber().number(), data.tpdu(), isRepeated, refusal -> answer(reference, refusal));
        } else if (message instanceof RelayMessage.RpSmma) {
            answer(reference, Optional.empty());
            center.available(link.subscriber().number());
        } else {
            answer(reference, Optional.of(RpCause.MESSAGE_NOT_COMPATIBLE));
        }
    }

    private void answer(int reference, Optional<RpCause> refusal) {
        RelayMessage relay = refusal.<RelayMessage>map(cause -> new RelayMessage.RpError(reference, cause))
                .orElseGet(() -> new RelayMessage.RpAck(reference, Optional.empty()));
        answer.prepare(new ShortMessageControl.CpData(transaction, relay));
        machine.fire(OriginatingEvent.ANSWERED);
    }
}
