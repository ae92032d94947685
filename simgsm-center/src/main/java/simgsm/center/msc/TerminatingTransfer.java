package simgsm.center.msc;

import java.time.Duration;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.octets.OctetString;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** A short message to a mobile: paging, CP-DATA (RP-DATA) down, CP-ACK up, CP-DATA (RP-ACK) up, CP-ACK down. */
final class TerminatingTransfer implements PagedTransaction {
    /** TR1N: the mobile's RP-ACK is awaited for 35 to 45 s (TS 24.011, 10.1). */
    private static final long TR1N_NANOS = Duration.ofSeconds(40).toNanos();

    private final Link link;
    private final TransactionIdentifier transaction;
    private final int reference;
    private final OctetString tpdu;
    private final Timers timers;
    private final Consumer<DeliveryOutcome> ended;
    private final CpRepeater data;
    private Timer relayGuard;
    private boolean isOnAir;
    private boolean isOver;

    TerminatingTransfer(
            Link link,
            TransactionIdentifier transaction,
            int reference,
            OctetString tpdu,
            Timers timers,
            Consumer<DeliveryOutcome> ended) {
        this.link = link;
        this.transaction = transaction;
        this.reference = reference;
        this.tpdu = tpdu;
        this.timers = timers;
        this.ended = ended;
        this.data = new CpRepeater(link, timers, () -> end(DeliveryOutcome.FAILED));
    }

    TransactionIdentifier transaction() {
        return transaction;
    }

    boolean isOnAir() {
        return isOnAir;
    }

    @Override
    public void radioConnected() {
        isOnAir = true;
        relayGuard = timers.start(TR1N_NANOS, () -> end(DeliveryOutcome.FAILED));
        Msisdn center = ShortMessageCenter.ADDRESS;
        data.send(new ShortMessageControl.CpData(transaction, new RelayMessage.RpData(reference, center, tpdu)));
    }

    @Override
    public void pagingFailed() {
        end(DeliveryOutcome.ABSENT);
    }

    void lose() {
        end(isOnAir ? DeliveryOutcome.FAILED : DeliveryOutcome.ABSENT);
    }

    void receive(ShortMessageControl message) {
        data.stop();
        if (message instanceof ShortMessageControl.CpData answer) {
            link.send(new ShortMessageControl.CpAck(transaction));
            receive(answer.relay());
        } else if (message instanceof ShortMessageControl.CpError) {
            end(DeliveryOutcome.FAILED);
        }
    }

    private void receive(RelayMessage relay) {
        if (relay.reference() != reference) {
            return;
        }
        if (relay instanceof RelayMessage.RpAck) {
            end(DeliveryOutcome.DELIVERED);
        } else if (relay instanceof RelayMessage.RpError error) {
            end(
                    error.cause() == RpCause.MEMORY_CAPACITY_EXCEEDED
                            ? DeliveryOutcome.MEMORY_FULL
                            : DeliveryOutcome.REFUSED);
        }
    }

    private void end(DeliveryOutcome outcome) {
        if (!isOver) {
            isOver = true;
            data.stop();
            timers.cancel(relayGuard);
            link.paging.cancel(this);
            ended.accept(outcome);
        }
    }
}
