package simgsm.center.msc;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.octets.OctetString;
import simgsm.timer.Timers;

/** The short message transactions of one link: what the mobile sends, and the one message that it is being given. */
final class ShortMessageTransfers {
    private static final int TRANSACTIONS = 7;
    private static final int REFERENCES = 256;

    private final Link link;
    private final Timers timers;
    private final ShortMessageCenter center;
    private final List<OriginatingTransfer> originating = new ArrayList<>(1);
    /** What began the latest transaction whose answer the mobile never acknowledged; null if it has. */
    private ShortMessageControl unconfirmed;

    private TerminatingTransfer terminating;
    private int nextTransaction;
    private int nextReference;

    ShortMessageTransfers(Link link, Timers timers, ShortMessageCenter center) {
        this.link = link;
        this.timers = timers;
        this.center = center;
    }

    boolean needRadio() {
        return !originating.isEmpty() || terminating != null && terminating.isOnAir();
    }

    void receive(ShortMessageControl message) {
        if (message.transaction().fromOtherSide()) {
            receiveForTerminating(message);
        } else {
            receiveForOriginating(message);
        }
    }

    private void receiveForOriginating(ShortMessageControl message) {
        Optional<OriginatingTransfer> transfer = originatingOf(message.transaction());
        if (transfer.isPresent()) {
            transfer.get().receive(message);
        } else if (!(message instanceof ShortMessageControl.CpData)) {
            refuseUnlessError(message, CpCause.INVALID_TRANSACTION_IDENTIFIER);
        } else if (originating.size() == TRANSACTIONS || !link.radio.takeService()) {
            refuseUnlessError(message, CpCause.NOT_COMPATIBLE_WITH_STATE);
        } else {
            // It may have been long on its way, and the transaction given up here meanwhile.
            boolean isRepeated = message.equals(unconfirmed);
            unconfirmed = null;
            OriginatingTransfer fresh = new OriginatingTransfer(
                    link, message.transaction().answered(), isRepeated, timers, center, this::originatingEnded);
            originating.add(fresh);
            fresh.receive(message);
        }
    }

    private void receiveForTerminating(ShortMessageControl message) {
        if (terminating != null
                && terminating.transaction().equals(message.transaction().answered())) {
            terminating.receive(message);
        } else {
            refuseUnlessError(message, CpCause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private void refuseUnlessError(ShortMessageControl message, int cpCause) {
        if (message instanceof ShortMessageControl.CpData) {
            link.send(new ShortMessageControl.CpError(message.transaction().answered(), cpCause));
        }
    }

    private Optional<OriginatingTransfer> originatingOf(TransactionIdentifier received) {
        return originating.stream()
                .filter(transfer -> transfer.transaction().equals(received.answered()))
                .findFirst();
    }

    private void originatingEnded(OriginatingTransfer transfer) {
        originating.remove(transfer);
        unconfirmed = transfer.isConfirmed() ? null : transfer.beginning();
        link.touched();
    }

    /** Gives the mobile a message, paging it if need be; one at a time. */
    void deliver(OctetString tpdu, Consumer<DeliveryOutcome> ended) {
        TransactionIdentifier transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        nextReference = (nextReference + 1) % REFERENCES;
        terminating = new TerminatingTransfer(link, transaction, nextReference, tpdu, timers, outcome -> {
            terminating = null;
            link.touched();
            ended.accept(outcome);
        });
        link.paging.request(terminating);
    }

    /** The radio connection has gone, or will not come. */
    void lose() {
        List.copyOf(originating).forEach(OriginatingTransfer::end);
        if (terminating != null) {
            terminating.lose();
        }
    }
}
