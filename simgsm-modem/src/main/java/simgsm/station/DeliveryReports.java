package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.HashMap;
import java.util.Map;
import simgsm.air.Msisdn;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.StatusReportTpdu;

/** Parts that a status report is still to come for, by their message reference: never more than there are references. */
final class DeliveryReports {
    private final StationLog log;
    private final Map<Integer, OutgoingMessage> expected = new HashMap<>();

    DeliveryReports(StationLog log) {
        this.log = log;
    }

    void expect(int reference, OutgoingMessage message) {
        expected.put(reference, message);
    }

    void cancel(int reference) {
        expected.remove(reference);
    }

    void arrived(StatusReportTpdu report) {
        OutgoingMessage message = expected.get(report.reference());
        if (message == null || !isFor(message.to(), report)) {
            log.trace(Level.INFO, "status report for an unknown message {0}", report.reference());
            return;
        }
        if (DeliveryStatus.isPending(report.status())) {
            return;
        }
        expected.remove(report.reference());
        if (DeliveryStatus.isDelivered(report.status())) {
            message.partDelivered();
        } else {
            log.trace(
                    Level.INFO,
                    "message {0} to {1} not delivered: {2}",
                    report.reference(),
                    message.to(),
                    DeliveryStatus.title(report.status()));
        }
    }

    private static boolean isFor(Msisdn to, StatusReportTpdu report) {
        return report.recipient().number().map(to::equals).orElse(false);
    }
}
