package simgsm.center.msc;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.timer.Timers;

/**
 * A short message from a mobile (TS 24.011, 5 and 6): CP-DATA (RP-DATA) up, CP-ACK down, then the centre stores it, and
 * only then CP-DATA (RP-ACK) down and CP-ACK up. RP-SMMA, "I have memory again", goes the same way.
 */
final class OriginatingTransfer {
    private final Link link;
    private final TransactionIdentifier transaction;
    private final boolean isRepeated;
    private final ShortMessageCenter center;
    private final Consumer<OriginatingTransfer> ended;
    private final CpRepeater answer;
    private boolean isOver;
    /** Null until the mobile's message has come. */
    private ShortMessageControl beginning;

    private boolean isConfirmed;

    /** @param isRepeated whether the mobile has sent the same before, in a transaction that was given up here */
    OriginatingTransfer(
            Link link,
            TransactionIdentifier transaction,
            boolean isRepeated,
            Timers timers,
            ShortMessageCenter center,
            Consumer<OriginatingTransfer> ended) {
        this.link = link;
        this.transaction = transaction;
        this.isRepeated = isRepeated;
        this.center = center;
        this.ended = ended;
        this.answer = new CpRepeater(link, timers, this::end);
    }

    TransactionIdentifier transaction() {
        return transaction;
    }

    ShortMessageControl beginning() {
        return beginning;
    }

    /** Whether the mobile has our answer. */
    boolean isConfirmed() {
        return isConfirmed;
    }

    void receive(ShortMessageControl message) {
        if (message instanceof ShortMessageControl.CpData data) {
            link.send(new ShortMessageControl.CpAck(transaction));
            // A repeated CP-DATA wants nothing but its acknowledgement.
            if (beginning == null) {
                beginning = message;
                relay(data.relay());
            }
        } else if (message instanceof ShortMessageControl.CpError || answer.isWaiting()) {
            isConfirmed = answer.isWaiting() && message instanceof ShortMessageControl.CpAck;
            end();
        }
    }

    private void relay(RelayMessage message) {
        int reference = message.reference();
        if (message instanceof RelayMessage.RpData && !link.moderation.admitsMessage()) {
            answer(reference, Optional.of(RpCause.CONGESTION));
        } else if (message instanceof RelayMessage.RpData data) {
            center.submit(link.subscriber.number(), data.tpdu(), isRepeated, refusal -> answer(reference, refusal));
        } else if (message instanceof RelayMessage.RpSmma) {
            answer(reference, Optional.empty());
            center.available(link.subscriber.number());
        } else {
            answer(reference, Optional.of(RpCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE));
        }
    }

    private void answer(int reference, Optional<RpCause> refusal) {
        if (isOver) {
            return;
        }
        RelayMessage relay = refusal.<RelayMessage>map(cause -> new RelayMessage.RpError(reference, cause))
                .orElseGet(() -> new RelayMessage.RpAck(reference, Optional.empty()));
        answer.send(new ShortMessageControl.CpData(transaction, relay));
    }

    void end() {
        isOver = true;
        answer.stop();
        ended.accept(this);
    }
}
