package simgsm.station.sms;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.StatusReportTpdu;
import simgsm.station.context.StationLog;

/**
 * The parts without their status report, by message reference. A reference has one octet (TS 23.040, 9.2.3.6), so two
 * of more than 256 parts share one. The receiver's number distinguishes them; of two to one receiver the older is
 * taken, because a service centre delivers in order. After the loss of a report this may be wrong. The newest {@value
 * #MAX_OF_ONE_REFERENCE} parts of a reference are kept.
 */
final class DeliveryReports {
    static final int MAX_OF_ONE_REFERENCE = 16;

    private final StationLog log;
    private final Map<Integer, Deque<OutgoingMessage>> expected = new HashMap<>();

    DeliveryReports(StationLog log) {
        this.log = log;
    }

    /** A part is sent, for the first time or again. */
    void expect(int reference, OutgoingMessage message) {
        Deque<OutgoingMessage> same = expected.computeIfAbsent(reference, key -> new ArrayDeque<>());
        if (same.peekLast() == message) {
            return;
        }
        if (same.size() == MAX_OF_ONE_REFERENCE) {
            same.remove();
        }
        same.add(message);
    }

    /** The part has failed. */
    void cancel(int reference, OutgoingMessage message) {
        Deque<OutgoingMessage> same = expected.get(reference);
        if (same != null) {
            same.remove(message);
            removeIfEmpty(reference, same);
        }
    }

    void arrived(StatusReportTpdu report) {
        Deque<OutgoingMessage> same = expected.getOrDefault(report.reference(), new ArrayDeque<>());
        Optional<OutgoingMessage> meant =
                same.stream().filter(each -> isFor(each.to(), report)).findFirst();
        if (meant.isEmpty()) {
            log.trace(Level.INFO, "status report for an unknown message {0}", report.reference());
        } else if (!DeliveryStatus.isPending(report.status())) {
            same.remove(meant.get());
            removeIfEmpty(report.reference(), same);
            report(meant.get(), report);
        }
    }

    private void report(OutgoingMessage message, StatusReportTpdu report) {
        if (DeliveryStatus.isDelivered(report.status())) {
            message.partDelivered();
        } else {
            log.trace(
                    Level.INFO,
                    "message {0} to {1} not delivered: {2}",
                    report.reference(),
                    message.to(),
                    DeliveryStatus.title(report.status()));
            message.partUndelivered(report.status());
        }
    }

    private void removeIfEmpty(int reference, Deque<OutgoingMessage> same) {
        if (same.isEmpty()) {
            expected.remove(reference);
        }
    }

    private static boolean isFor(Msisdn to, StatusReportTpdu report) {
        return report.recipient().value().equals(to.digits());
    }
}
