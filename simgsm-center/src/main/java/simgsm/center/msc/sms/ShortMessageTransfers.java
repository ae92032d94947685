package simgsm.center.msc.sms;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.Link;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.octets.OctetString;

/** The short message transactions of one link: the mobile's, and at most one to it. */
final class ShortMessageTransfers {
    private static final int TRANSACTIONS = 7;
    private static final int REFERENCES = 256;

    // Causes of CP-ERROR (TS 24.011, 8.1.4.2).
    private static final int INVALID_TRANSACTION_IDENTIFIER = 81;
    private static final int NOT_COMPATIBLE_WITH_STATE = 98;

    private final Link link;
    private final ShortMessageCenter center;
    private final List<OriginatingTransfer> originating = new ArrayList<>(1);
    /** The first message of the latest transaction, if the mobile did not acknowledge its answer; else null. */
    private ShortMessageControl unconfirmed;

    private TerminatingTransfer terminating;
    private int nextTransaction;
    private int nextReference;

    ShortMessageTransfers(Link link, ShortMessageCenter center) {
        this.link = link;
        this.center = center;
    }

    boolean needRadio() {
        return !originating.isEmpty() || terminating != null && terminating.needsRadio();
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
            refuseUnlessError(message, INVALID_TRANSACTION_IDENTIFIER);
        } else if (originating.size() == TRANSACTIONS || !link.radio().takeService()) {
            refuseUnlessError(message, NOT_COMPATIBLE_WITH_STATE);
        } else {
            // the mobile may have sent this message before, in a transaction that has ended here
            boolean isRepeated = message.equals(unconfirmed);
            unconfirmed = null;
            OriginatingTransfer fresh =
                    new OriginatingTransfer(link, message, isRepeated, center, this::originatingEnded);
            originating.add(fresh);
            fresh.receive(message);
        }
    }

    private void receiveForTerminating(ShortMessageControl message) {
        if (terminating != null
                && terminating.transaction().equals(message.transaction().answered())) {
            terminating.receive(message);
        } else {
            refuseUnlessError(message, INVALID_TRANSACTION_IDENTIFIER);
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
        unconfirmed = transfer.isConfirmed() ? null : transfer.first();
        link.touch();
    }

    /** Delivers a message to the mobile, after paging if necessary; one at a time. */
    void deliver(OctetString tpdu, Consumer<DeliveryOutcome> ended) {
        TransactionIdentifier transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        nextReference = (nextReference + 1) % REFERENCES;
        terminating = new TerminatingTransfer(link, transaction, nextReference, tpdu, outcome -> {
            terminating = null;
            link.touch();
            ended.accept(outcome);
        });
        link.paging().request(terminating);
    }

    /** Handles the loss or lack of the radio connection. */
    void radioLost() {
        List.copyOf(originating).forEach(OriginatingTransfer::radioLost);
        if (terminating != null) {
            terminating.radioLost();
        }
    }
}
