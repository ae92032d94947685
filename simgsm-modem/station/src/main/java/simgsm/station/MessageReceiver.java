package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.Reassembler;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;

/** Takes what the network delivers (TS 24.011, 5.3 and 6.3, mobile terminated): each CP-DATA is answered at once. */
final class MessageReceiver {
    private static final int MOST_RETRANSMISSIONS = 3;

    /** An answer of ours that the network has not acknowledged yet. */
    private record Answer(CpData to, CpData data, OctetString tpdu) {}

    private final StationParts parts;
    private final DeliveryReports reports;
    private final Reassembler reassembler = new Reassembler();
    private final DuplicateFilter duplicates = new DuplicateFilter();
    /** Null while nothing is unacknowledged. */
    private Answer answer;

    private int retransmissions;
    private boolean isMemoryFull;
    /** Whether the network knows of it, and waits to hear that there is room again. */
    private boolean hasRefused;

    MessageReceiver(StationParts parts, DeliveryReports reports) {
        this.parts = parts;
        this.reports = reports;
    }

    boolean isBusy() {
        return answer != null;
    }

    /** Messages are refused from now on; status reports are none, and a message taken before is acknowledged again. */
    void memoryFull() {
        isMemoryFull = true;
    }

    /** @return whether the network is to be told */
    boolean memoryAvailable() {
        boolean isWaitedFor = isMemoryFull && hasRefused;
        isMemoryFull = false;
        hasRefused = false;
        return isWaitedFor;
    }

    void arrived(CpData data) {
        parts.radio().send(new CpAck(data.transaction().answered()));
        if (answer != null && answer.to().equals(data)) {
            return;
        }
        // Whoever begins anew without CP-ACK has not heard our answer to the last one.
        radioLost();
        if (data.relay() instanceof RpData relayed) {
            answer(data, take(relayed), relayed.tpdu());
        } else {
            RelayMessage refusal = new RpError(data.relay().reference(), RpCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
            answer(data, refusal, OctetString.of(new byte[0]));
        }
    }

    /** The network has our answer; or it wants none, because it has given the transaction up, and may bring the message again. */
    void ended(TransactionIdentifier received, boolean isAcknowledged) {
        if (answer != null && answer.to().transaction().equals(received)) {
            if (!isAcknowledged) {
                duplicates.unconfirmed(answer.tpdu());
            }
            forgetAnswer();
        }
    }

    void tc1Expired() {
        if (answer == null) {
            return;
        }
        if (retransmissions++ < MOST_RETRANSMISSIONS) {
            sendAnswer();
        } else {
            radioLost();
        }
    }

    void radioLost() {
        if (answer != null) {
            duplicates.unconfirmed(answer.tpdu());
            forgetAnswer();
        }
    }

    void linkLost() {
        radioLost();
        duplicates.linkLost();
    }

    private void answer(CpData to, RelayMessage relay, OctetString tpdu) {
        answer = new Answer(to, new CpData(to.transaction().answered(), relay), tpdu);
        retransmissions = 0;
        sendAnswer();
    }

    private void sendAnswer() {
        parts.timers().start(StationTimer.TC1_INCOMING);
        parts.radio().send(answer.data());
    }

    private void forgetAnswer() {
        answer = null;
        parts.timers().stop(StationTimer.TC1_INCOMING);
    }

    private RelayMessage take(RpData relayed) {
        try {
            Tpdu tpdu = TpduCodec.decode(relayed.tpdu(), Direction.DOWNLINK);
            if (isMemoryFull && tpdu instanceof DeliverTpdu && !duplicates.mayBeDuplicate(relayed.tpdu())) {
                hasRefused = true;
                return new RpError(relayed.reference(), RpCause.MEMORY_CAPACITY_EXCEEDED);
            }
            if (!duplicates.isDuplicate(relayed.tpdu())) {
                take(tpdu);
            }
            return new RpAck(relayed.reference(), Optional.empty());
        } catch (ProtocolViolation e) {
            parts.log().trace(Level.WARNING, "short message refused: {0}", e.getMessage());
            return new RpError(
                    relayed.reference(), RpCause.ofCode(e.statusCause().code()));
        }
    }

    private void take(Tpdu tpdu) {
        if (tpdu instanceof DeliverTpdu deliver) {
            String from = deliver.originator().value();
            reassembler
                    .accept(
                            deliver.originator(),
                            deliver.userData(),
                            parts.timers().nowNanos())
                    .ifPresent(text -> parts.notifications().add(listener -> listener.messageReceived(from, text)));
        } else if (tpdu instanceof StatusReportTpdu report) {
            reports.arrived(report);
        }
    }
}
