package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.Msisdn;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;

/** What a station hears of what it has sent. */
class MessageReportsTest extends MessageStage {
    @Test
    void theStatusReportTellsTheDelivery() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        acknowledge(data);
        scene.expect(CpAck.class);
        scene.reported.clear();
        delivered(1, report(id, 0x30));
        assertEquals(List.of(), scene.reported.lines());
        delivered(2, report(id, 0x00));
        assertEquals(List.of("delivered " + id + " to 5550200"), scene.reported.lines());
        delivered(3, report(id, 0x00));
        assertEquals(List.of("delivered " + id + " to 5550200"), scene.reported.lines());
    }

    @Test
    void deliveryIsReportedAfterTheLastPart() {
        int id = scene.station.sendMessage(Scene.OTHER, "x".repeat(200));
        scene.acceptService();
        CpData first = expectSubmit();
        acknowledge(first);
        scene.expect(CmServiceRequest.class);
        scene.expect(CpAck.class);
        delivered(1, report(id, 0x00));
        scene.down(new CmServiceAccept());
        CpData second = expectSubmit();
        acknowledge(second);
        scene.expect(CpAck.class);
        assertEquals(List.of("sent " + id + " to 5550200 in 2"), scene.reported.lines());
        delivered(2, report((id + 1) % 256, 0x00));
        assertEquals(
                List.of("sent " + id + " to 5550200 in 2", "delivered " + id + " to 5550200"), scene.reported.lines());
    }

    @Test
    void aReportForAnotherReceiverIsIgnoredAndOneOfFailureIsTheLast() {
        int id = scene.station.sendMessage(new Msisdn("5550777"), "hello");
        scene.acceptService();
        acknowledge(expectSubmit());
        scene.expect(CpAck.class);
        scene.reported.clear();
        delivered(1, report(id, 0x00));
        int other = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        acknowledge(expectSubmit());
        scene.expect(CpAck.class);
        scene.reported.clear();
        delivered(2, report(other, 0x46));
        delivered(3, report(other, 0x00));
        assertEquals(List.of("undelivered " + other + " to 5550200, status 70"), scene.reported.lines());
    }

    @Test
    void aMessageOfManyPartsIsUndeliveredOnce() {
        int id = scene.station.sendMessage(Scene.OTHER, "x".repeat(300));
        scene.acceptService();
        acknowledge(expectSubmit());
        scene.expect(CmServiceRequest.class);
        scene.expect(CpAck.class);
        scene.down(new CmServiceAccept());
        acknowledge(expectSubmit());
        scene.expect(CpAck.class);
        scene.reported.clear();
        delivered(1, report(id, 0x46));
        delivered(2, report((id + 1) % 256, 0x46));
        assertEquals(List.of("undelivered " + id + " to 5550200, status 70"), scene.reported.lines());
    }
}
