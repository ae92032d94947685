package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.StatusReportTpdu;

/**
 * Parts that a status report is still to come for, by their message reference. A reference has one octet (TS 23.040,
 * 9.2.3.6), so with more than 256 parts under way two of them bear the same; the receiver's number tells them apart, and of
 * two for one receiver the older is meant, since a service centre delivers in order. That is a guess once a report has been
 * lost. Of one reference the newest {@value #MOST_OF_ONE_REFERENCE} parts are remembered.
 */
final class DeliveryReports {
    static final int MOST_OF_ONE_REFERENCE = 16;

    private final StationLog log;
    private final Map<Integer, Deque<OutgoingMessage>> expected = new HashMap<>();

    DeliveryReports(StationLog log) {
        this.log = log;
    }

    /** A part goes out, perhaps once more. */
    void expect(int reference, OutgoingMessage message) {
        Deque<OutgoingMessage> same = expected.computeIfAbsent(reference, any -> new ArrayDeque<>());
        if (same.peekLast() == message) {
            return;
        }
        if (same.size() == MOST_OF_ONE_REFERENCE) {
            same.remove();
        }
        same.add(message);
    }

    /** The part was not taken; it may not even have gone out. */
    void cancel(int reference, OutgoingMessage message) {
        Deque<OutgoingMessage> same = expected.get(reference);
        if (same != null) {
            same.remove(message);
            forgetIfEmpty(reference, same);
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
            forgetIfEmpty(report.reference(), same);
            tell(meant.get(), report);
        }
    }

    private void tell(OutgoingMessage message, StatusReportTpdu report) {
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

    private void forgetIfEmpty(int reference, Deque<OutgoingMessage> same) {
        if (same.isEmpty()) {
            expected.remove(reference);
        }
    }

    private static boolean isFor(Msisdn to, StatusReportTpdu report) {
        return report.recipient().number().map(to::equals).orElse(false);
    }
}
