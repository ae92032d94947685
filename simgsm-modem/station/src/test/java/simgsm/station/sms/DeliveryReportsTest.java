package simgsm.station.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.octets.Timestamp;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;

class DeliveryReportsTest {
    private static final Timestamp NOON = Timestamp.of(OffsetDateTime.of(2026, 11, 21, 12, 0, 0, 0, ZoneOffset.UTC));
    private static final Msisdn ROBOT = new Msisdn("5550200");
    private static final Msisdn OTHER = new Msisdn("5550201");
    private static final int REFERENCE = 7;

    private final List<Integer> delivered = new ArrayList<>();
    private final StationContext context = StationContext.of(
            StationIdentity.ofOpenNumber(new Msisdn("5550100"), Imei.random(new Random(1)), "a test"),
            event -> {
                if (event instanceof StationEvent.MessageDelivered report) {
                    delivered.add(report.id());
                }
            },
            () -> {});
    private final DeliveryReports reports = new DeliveryReports(context.log());

    private OutgoingMessage sent(int id, Msisdn to) {
        OutgoingMessage message = new OutgoingMessage(id, to, 1, context.events());
        reports.expect(REFERENCE, message);
        message.partAcknowledged();
        return message;
    }

    private void report(Msisdn of) {
        reports.arrived(
                new StatusReportTpdu(false, REFERENCE, SmsAddress.of(of), NOON, NOON, DeliveryStatus.DELIVERED));
        context.events().deliver();
    }

    @Test
    void ofTwoMessagesOfOneReferenceTheOlderIsMeantFirst() {
        sent(1, ROBOT);
        sent(2, ROBOT);
        report(ROBOT);
        assertEquals(List.of(1), delivered);
        report(ROBOT);
        report(ROBOT);
        assertEquals(List.of(1, 2), delivered);
    }

    @Test
    void theReceiverTellsMessagesOfOneReferenceApart() {
        sent(1, ROBOT);
        sent(2, OTHER);
        report(OTHER);
        assertEquals(List.of(2), delivered);
    }

    @Test
    void aMessageThatIsSentAgainIsExpectedOnce() {
        OutgoingMessage message = sent(1, ROBOT);
        reports.expect(REFERENCE, message);
        sent(2, ROBOT);
        report(ROBOT);
        report(ROBOT);
        assertEquals(List.of(1, 2), delivered);
    }

    @Test
    void aMessageThatFailsTakesItsOwnExpectationAlong() {
        sent(1, ROBOT);
        reports.cancel(REFERENCE, new OutgoingMessage(2, ROBOT, 1, context.events()));
        report(ROBOT);
        assertEquals(List.of(1), delivered);
    }

    @Test
    void theOldestOfTooManyIsForgotten() {
        for (int id = 0; id <= DeliveryReports.MAX_OF_ONE_REFERENCE; id++) {
            sent(id, ROBOT);
        }
        report(ROBOT);
        assertEquals(List.of(1), delivered);
    }
}
