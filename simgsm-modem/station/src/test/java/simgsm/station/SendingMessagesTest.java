package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage.DataIndication;
import simgsm.abis.RslMessage.Sapi;
import simgsm.air.CallControl.Setup;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationEvent;

/** What a station hands in. */
class SendingMessagesTest extends MessageStage {
    @Test
    void aMessageGoesUpInCpAndRpAndIsSentWhenTheNetworkAcknowledges() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        assertEquals(
                ServiceType.SHORT_MESSAGE,
                scene.expectFirst(CmServiceRequest.class).service());
        scene.expectNothing();
        scene.down(new CmServiceAccept());
        CpData data = expectSubmit();
        assertEquals(new TransactionIdentifier(0, false), data.transaction());
        SubmitTpdu submit = submitIn(data);
        assertEquals("hello", submit.userData().text());
        assertEquals(SmsAddress.of(Scene.OTHER), submit.destination());
        assertEquals(id, submit.reference());
        assertTrue(submit.statusReportRequest());
        assertFalse(submit.rejectDuplicates());
        scene.down(new CpAck(data.transaction().answered()));
        assertEquals(List.of(), scene.reported.lines());
        scene.down(new CpData(data.transaction().answered(), new RpAck(id, Optional.empty())));
        scene.expect(new CpAck(data.transaction()));
        assertEquals(List.of("sent " + id + " to 5550200 in 1"), scene.reported.lines());
        scene.releaseChannel();
        scene.expectNothing();
    }

    @Test
    void aLongTextGoesInPartsOneAfterTheOtherOnOneChannel() {
        String text = "x".repeat(400);
        int id = scene.station.sendMessage(Scene.OTHER, text);
        StringBuilder arrived = new StringBuilder();
        for (int part = 1; part <= 3; part++) {
            scene.acceptService();
            CpData data = expectSubmit();
            assertEquals(part - 1, data.transaction().value());
            SubmitTpdu submit = submitIn(data);
            assertEquals((id + part - 1) % 256, submit.reference());
            assertEquals(part, submit.userData().concatenation().orElseThrow().part());
            arrived.append(submit.userData().text());
            assertEquals(List.of(), scene.reported.lines());
            acknowledge(data);
            if (part < 3) {
                // The next request goes before the acknowledgement, so that the network keeps the channel.
                CmServiceRequest next = scene.expect(CmServiceRequest.class);
                scene.expect(new CpAck(data.transaction()));
                assertEquals(ServiceType.SHORT_MESSAGE, next.service());
                scene.up.add(new DataIndication(
                        Sapi.SIGNALLING, OctetString.of(Layer3Codec.encode(next, Direction.UPLINK, 0))));
            }
        }
        assertEquals(text, arrived.toString());
        assertEquals(List.of("sent " + id + " to 5550200 in 3"), scene.reported.lines());
    }

    @Test
    void aRefusedMessageFailsWithTheNetworksCauseAndTakesItsOtherPartsAlong() {
        int id = scene.station.sendMessage(Scene.OTHER, "x".repeat(400));
        int second = scene.station.sendMessage(Scene.OTHER, "next");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpAck(data.transaction().answered()));
        scene.down(new CpData(data.transaction().answered(), new RpError(id, RpCause.UNASSIGNED_NUMBER)));
        assertEquals(List.of("failed " + id + " to 5550200 1"), scene.reported.lines());
        scene.expect(CmServiceRequest.class);
        scene.expect(CpAck.class);
        scene.down(new CmServiceAccept());
        CpData next = expectSubmit();
        assertEquals("next", submitIn(next).userData().text());
        assertEquals(second, next.relay().reference());
    }

    @Test
    void cpDataThatIsNotAcknowledgedIsRepeatedThreeTimesAndThenGivenUp() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        for (int i = 0; i < 3; i++) {
            scene.pass(5 * Scene.SECOND - 1);
            scene.expectNothing();
            scene.pass(1);
            scene.expect(data);
        }
        scene.pass(5 * Scene.SECOND);
        assertEquals(List.of("failed " + id + " to 5550200 41"), scene.reported.lines());
    }

    @Test
    void withoutAnRpAnswerTheMessageFailsAfterTr1m() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpAck(data.transaction().answered()));
        scene.pass(40 * Scene.SECOND - 1);
        assertEquals(List.of(), scene.reported.lines());
        scene.pass(1);
        assertEquals(List.of("failed " + id + " to 5550200 41"), scene.reported.lines());
    }

    @Test
    void anAnswerWithoutCpAckCounts() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpData(data.transaction().answered(), new RpAck(id, Optional.empty())));
        assertEquals(List.of("sent " + id + " to 5550200 in 1"), scene.reported.lines());
    }

    @Test
    void anAnswerToAnotherReferenceDoesNotCount() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpAck(data.transaction().answered()));
        scene.down(new CpData(data.transaction().answered(), new RpAck((id + 1) % 256, Optional.empty())));
        scene.expect(new CpAck(data.transaction()));
        assertEquals(List.of(), scene.reported.lines());
    }

    @Test
    void aCpErrorFailsTheMessage() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpError(data.transaction().answered(), 22));
        assertEquals(List.of("failed " + id + " to 5550200 42"), scene.reported.lines());
    }

    @Test
    void aRefusedServiceFailsTheMessage() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.expect(CmServiceRequest.class);
        scene.down(new CmServiceReject(RejectCause.NETWORK_FAILURE));
        assertEquals(List.of("failed " + id + " to 5550200 38"), scene.reported.lines());
    }

    @Test
    void aMessageWrittenWithoutServiceWaitsForIt() {
        scene.linkDown();
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.pass(39 * Scene.SECOND);
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.acceptService();
        acknowledge(expectSubmit());
        assertTrue(scene.reported.lines().contains("sent " + id + " to 5550200 in 1"));
    }

    @Test
    void aMessageFailsWhenServiceDoesNotComeIn40Seconds() {
        scene.linkDown();
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.pass(40 * Scene.SECOND - 1);
        assertEquals(List.of("unregistered"), scene.reported.lines());
        scene.pass(1);
        assertEquals(List.of("unregistered", "failed " + id + " to 5550200 38"), scene.reported.lines());
    }

    @Test
    void aMessageUnderWayWhenTheLinkIsLostIsSentAgainAndSaysSo() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData first = expectSubmit();
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.acceptService();
        CpData second = expectSubmit();
        assertTrue(submitIn(second).rejectDuplicates());
        assertEquals(submitIn(first).reference(), submitIn(second).reference());
        acknowledge(second);
        assertEquals(
                List.of("unregistered", "registered 5550100", "sent " + id + " to 5550200 in 1"),
                scene.reported.lines());
    }

    @Test
    void aMessageWhoseChannelIsLostFourTimesIsGivenUp() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        for (int i = 0; i < 4; i++) {
            scene.acceptService();
            expectSubmit();
            scene.releaseChannel();
        }
        assertEquals(List.of("failed " + id + " to 5550200 38"), scene.reported.lines());
        scene.expectNothing();
    }

    @Test
    void aRequestThatCrossesTheReleaseIsRepeated() {
        scene.station.sendMessage(Scene.OTHER, "one");
        scene.acceptService();
        acknowledge(expectSubmit());
        scene.expect(CpAck.class);
        scene.station.sendMessage(Scene.OTHER, "two");
        scene.expect(CmServiceRequest.class);
        scene.down(new ChannelRelease(0));
        scene.expectReleaseIndication();
        scene.expectFirst(CmServiceRequest.class);
        scene.down(new CmServiceAccept());
        assertEquals("two", submitIn(expectSubmit()).userData().text());
    }

    @Test
    void aStationThatIsOffRefusesAtOnce() {
        scene.station.powerOff();
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        assertEquals(List.of("unregistered", "failed " + id + " to 5550200 38"), scene.reported.lines());
    }

    @Test
    void poweringOffFailsEachWaitingMessageOnce() {
        int first = scene.station.sendMessage(Scene.OTHER, "x".repeat(400));
        int second = scene.station.sendMessage(Scene.OTHER, "y".repeat(400));
        scene.station.powerOff();
        assertEquals(
                List.of("failed " + first + " to 5550200 38", "failed " + second + " to 5550200 38", "unregistered"),
                scene.reported.lines());
    }

    @Test
    void aTextOfTooManyPartsIsRefused() {
        assertThrows(
                IllegalArgumentException.class,
                () -> scene.station.sendMessage(Scene.OTHER, "x".repeat(153 * 255 + 1)));
        scene.expectNothing();
    }

    @Test
    void referencesComeRoundAfter255AndIdsDoNot() {
        int first = scene.station.sendMessage(Scene.OTHER, "x");
        for (int i = 1; i <= 256; i++) {
            int id = scene.station.sendMessage(Scene.OTHER, "x");
            assertEquals(first + i, id);
            assertEquals((first + i) % 256, new StationEvent.MessageSent(id, Scene.OTHER, 1).reference());
        }
        for (int i = 0; i <= 256; i++) {
            scene.acceptService();
            if (i > 0) {
                scene.expect(CpAck.class);
            }
            CpData data = expectSubmit();
            assertEquals((first + i) % 256, data.relay().reference());
            assertEquals((first + i) % 256, submitIn(data).reference());
            acknowledge(data);
        }
        assertEquals(
                IntStream.rangeClosed(first, first + 256)
                        .mapToObj(id -> "sent " + id + " to 5550200 in 1")
                        .toList(),
                scene.reported.lines());
    }

    @Test
    void aMessageMayBeSentDuringACall() {
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        scene.expect(Setup.class);
        scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        acknowledge(data);
        scene.expect(new CpAck(data.transaction()));
        assertEquals(MobileCallState.CALL_INITIATED, scene.station.snapshot().callState());
    }
}
