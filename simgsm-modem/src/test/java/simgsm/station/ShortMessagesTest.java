package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.CallControl.Setup;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.OctetString;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RpCause;
import simgsm.air.RslMessage;
import simgsm.air.RslMessage.DataIndication;
import simgsm.air.RslMessage.Sapi;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.air.TransactionIdentifier;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.MessageSplitter;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Timestamp;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

class ShortMessagesTest {
    private static final TransactionIdentifier THEIRS = new TransactionIdentifier(2, false);
    private static final Timestamp NOON = Timestamp.of(OffsetDateTime.of(2026, 11, 21, 12, 0, 0, 0, ZoneOffset.UTC));

    private final Scene scene = Scene.registered();

    /** Reads the next CP-DATA and the SUBMIT within. */
    private CpData expectSubmit() {
        return scene.expect(CpData.class);
    }

    private static SubmitTpdu submitIn(CpData data) {
        try {
            return (SubmitTpdu) TpduCodec.decode(((RpData) data.relay()).tpdu(), Direction.UPLINK);
        } catch (ProtocolViolation e) {
            throw new AssertionError(e);
        }
    }

    private void acknowledge(CpData data) {
        scene.down(new CpAck(data.transaction().answered()));
        scene.down(
                new CpData(data.transaction().answered(), new RpAck(data.relay().reference(), Optional.empty())));
    }

    private void openForDelivery() {
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
    }

    private static OctetString deliver(UserData data) {
        return TpduCodec.encode(new DeliverTpdu(false, false, false, SmsAddress.of(Scene.OTHER), 0, NOON, data));
    }

    private void down(int reference, OctetString tpdu) {
        scene.down(new CpData(THEIRS, new RpData(reference, StationIdentity.TEST_SERVICE_CENTER, tpdu)));
    }

    /** A whole delivery as the network sees it. */
    private void delivered(int reference, OctetString tpdu) {
        down(reference, tpdu);
        scene.expect(new CpAck(THEIRS.answered()));
        scene.expect(new CpData(THEIRS.answered(), new RpAck(reference, Optional.empty())));
        scene.down(new CpAck(THEIRS));
    }

    private static OctetString report(int reference, int status) {
        Tpdu report = new StatusReportTpdu(false, reference, SmsAddress.of(Scene.OTHER), NOON, NOON, status);
        return TpduCodec.encode(report);
    }

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
        assertEquals(List.of(), scene.told.lines());
        scene.down(new CpData(data.transaction().answered(), new RpAck(id, Optional.empty())));
        scene.expect(new CpAck(data.transaction()));
        assertEquals(List.of("sent " + id + " to 5550200 in 1"), scene.told.lines());
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
            assertEquals(List.of(), scene.told.lines());
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
        assertEquals(List.of("sent " + id + " to 5550200 in 3"), scene.told.lines());
    }

    @Test
    void aRefusedMessageFailsWithTheNetworksCauseAndTakesItsOtherPartsAlong() {
        int id = scene.station.sendMessage(Scene.OTHER, "x".repeat(400));
        int second = scene.station.sendMessage(Scene.OTHER, "next");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpAck(data.transaction().answered()));
        scene.down(new CpData(data.transaction().answered(), new RpError(id, RpCause.UNASSIGNED_NUMBER)));
        assertEquals(List.of("failed " + id + " to 5550200 1"), scene.told.lines());
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
        assertEquals(List.of("failed " + id + " to 5550200 41"), scene.told.lines());
    }

    @Test
    void withoutAnRpAnswerTheMessageFailsAfterTr1m() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpAck(data.transaction().answered()));
        scene.pass(40 * Scene.SECOND - 1);
        assertEquals(List.of(), scene.told.lines());
        scene.pass(1);
        assertEquals(List.of("failed " + id + " to 5550200 41"), scene.told.lines());
    }

    @Test
    void anAnswerWithoutCpAckCounts() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpData(data.transaction().answered(), new RpAck(id, Optional.empty())));
        assertEquals(List.of("sent " + id + " to 5550200 in 1"), scene.told.lines());
    }

    @Test
    void anAnswerToAnotherReferenceDoesNotCount() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpAck(data.transaction().answered()));
        scene.down(new CpData(data.transaction().answered(), new RpAck((id + 1) % 256, Optional.empty())));
        scene.expect(new CpAck(data.transaction()));
        assertEquals(List.of(), scene.told.lines());
    }

    @Test
    void aCpErrorFailsTheMessage() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        scene.down(new CpError(data.transaction().answered(), 22));
        assertEquals(List.of("failed " + id + " to 5550200 42"), scene.told.lines());
    }

    @Test
    void aRefusedServiceFailsTheMessage() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.expect(CmServiceRequest.class);
        scene.down(new CmServiceReject(RejectCause.NETWORK_FAILURE));
        assertEquals(List.of("failed " + id + " to 5550200 38"), scene.told.lines());
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
        assertTrue(scene.told.lines().contains("sent " + id + " to 5550200 in 1"));
    }

    @Test
    void aMessageFailsWhenServiceDoesNotComeIn40Seconds() {
        scene.linkDown();
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.pass(40 * Scene.SECOND - 1);
        assertEquals(List.of("unregistered"), scene.told.lines());
        scene.pass(1);
        assertEquals(List.of("unregistered", "failed " + id + " to 5550200 38"), scene.told.lines());
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
                List.of("unregistered", "registered 5550100", "sent " + id + " to 5550200 in 1"), scene.told.lines());
    }

    @Test
    void aMessageWhoseChannelIsLostFourTimesIsGivenUp() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        for (int i = 0; i < 4; i++) {
            scene.acceptService();
            expectSubmit();
            scene.releaseChannel();
        }
        assertEquals(List.of("failed " + id + " to 5550200 38"), scene.told.lines());
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
        assertEquals(List.of("unregistered", "failed " + id + " to 5550200 38"), scene.told.lines());
    }

    @Test
    void poweringOffFailsEachWaitingMessageOnce() {
        int first = scene.station.sendMessage(Scene.OTHER, "x".repeat(400));
        int second = scene.station.sendMessage(Scene.OTHER, "y".repeat(400));
        scene.station.powerOff();
        assertEquals(
                List.of("failed " + first + " to 5550200 38", "failed " + second + " to 5550200 38", "unregistered"),
                scene.told.lines());
    }

    @Test
    void aTextOfTooManyPartsIsRefused() {
        assertThrows(
                IllegalArgumentException.class,
                () -> scene.station.sendMessage(Scene.OTHER, "x".repeat(153 * 255 + 1)));
        scene.expectNothing();
    }

    @Test
    void referencesComeRoundAfter255() {
        int first = scene.station.sendMessage(Scene.OTHER, "x");
        for (int i = 1; i < 256; i++) {
            assertEquals((first + i) % 256, scene.station.sendMessage(Scene.OTHER, "x"));
        }
        assertEquals(first, scene.station.sendMessage(Scene.OTHER, "x"));
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
        assertEquals(CallState.CALL_INITIATED, scene.station.snapshot().callState());
    }

    @Test
    void aDeliveredMessageIsAcknowledgedAndToldOnce() {
        openForDelivery();
        delivered(7, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola"), scene.told.lines());
        scene.releaseChannel();
    }

    @Test
    void twoMessagesAlikeAreTwo() {
        openForDelivery();
        delivered(1, deliver(UserData.of("hola")));
        delivered(2, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola", "message from 5550200: hola"), scene.told.lines());
    }

    @Test
    void theSameCpDataAgainIsAcknowledgedOnly() {
        openForDelivery();
        OctetString tpdu = deliver(UserData.of("hola"));
        down(1, tpdu);
        down(1, tpdu);
        scene.expect(CpAck.class);
        scene.expect(CpData.class);
        scene.expect(CpAck.class);
        scene.expectNothing();
        assertEquals(List.of("message from 5550200: hola"), scene.told.lines());
    }

    @Test
    void aMessageThatComesAgainOverANewLinkIsAcknowledgedButNotTold() {
        openForDelivery();
        OctetString tpdu = deliver(UserData.of("hola"));
        delivered(1, tpdu);
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        delivered(0, tpdu);
        delivered(1, tpdu);
        assertEquals(
                List.of(
                        "message from 5550200: hola",
                        "unregistered",
                        "registered 5550100",
                        "message from 5550200: hola"),
                scene.told.lines());
    }

    @Test
    void aMessageWhoseAcknowledgementTheNetworkNeverSawMayComeAgain() {
        openForDelivery();
        OctetString tpdu = deliver(UserData.of("hola"));
        down(1, tpdu);
        scene.expect(CpAck.class);
        CpData answer = scene.expect(CpData.class);
        for (int i = 0; i < 3; i++) {
            scene.pass(5 * Scene.SECOND);
            scene.expect(answer);
        }
        scene.pass(5 * Scene.SECOND);
        scene.expectNothing();
        delivered(2, tpdu);
        assertEquals(List.of("message from 5550200: hola"), scene.told.lines());
    }

    @Test
    void partsAreJoinedInWhateverOrderTheyCome() {
        openForDelivery();
        String text = "abc".repeat(150);
        List<UserData> parts = MessageSplitter.split(text, 9);
        delivered(1, deliver(parts.get(2)));
        delivered(2, deliver(parts.get(0)));
        assertEquals(List.of(), scene.told.lines());
        delivered(3, deliver(parts.get(1)));
        assertEquals(List.of("message from 5550200: " + text), scene.told.lines());
    }

    @Test
    void aSenderWithANameIsToldByIt() {
        openForDelivery();
        delivered(
                1,
                TpduCodec.encode(new DeliverTpdu(
                        false, false, false, SmsAddress.ofLetters("SimGSM"), 0, NOON, UserData.of("x"))));
        assertEquals(List.of("message from SimGSM: x"), scene.told.lines());
    }

    @Test
    void aBrokenTransferUnitIsRefusedInRp() {
        openForDelivery();
        down(1, OctetString.ofHex("04ff91"));
        scene.expect(CpAck.class);
        RpError error = (RpError) scene.expect(CpData.class).relay();
        assertEquals(1, error.reference());
        assertTrue(List.of(96, 111).contains(error.cause().code()), error.toString());
        assertEquals(List.of(), scene.told.lines());
    }

    @Test
    void aBrokenRpMessageIsRefusedToo() {
        openForDelivery();
        scene.downHex("2901020133");
        scene.expect(CpAck.class);
        assertTrue(scene.expect(CpData.class).relay() instanceof RpError);
        scene.downHex("297f");
        assertEquals(97, scene.expect(CpError.class).cause());
    }

    @Test
    void dataOfAnUnknownTransactionGetsCpError81() {
        openForDelivery();
        TransactionIdentifier unknown = new TransactionIdentifier(4, true);
        scene.down(new CpData(unknown, new RpAck(1, Optional.empty())));
        scene.expect(new CpError(unknown.answered(), 81));
        scene.down(new CpAck(unknown));
        scene.expectNothing();
    }

    @Test
    void theStatusReportTellsTheDelivery() {
        int id = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        CpData data = expectSubmit();
        acknowledge(data);
        scene.expect(CpAck.class);
        scene.told.clear();
        delivered(1, report(id, 0x30));
        assertEquals(List.of(), scene.told.lines());
        delivered(2, report(id, 0x00));
        assertEquals(List.of("delivered " + id + " to 5550200"), scene.told.lines());
        delivered(3, report(id, 0x00));
        assertEquals(List.of("delivered " + id + " to 5550200"), scene.told.lines());
    }

    @Test
    void deliveryIsToldAfterTheLastPart() {
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
        assertEquals(List.of("sent " + id + " to 5550200 in 2"), scene.told.lines());
        delivered(2, report((id + 1) % 256, 0x00));
        assertEquals(List.of("sent " + id + " to 5550200 in 2", "delivered " + id + " to 5550200"), scene.told.lines());
    }

    @Test
    void aReportForSomebodyElseOrOfFailureTellsNothing() {
        int id = scene.station.sendMessage(new Msisdn("5550777"), "hello");
        scene.acceptService();
        acknowledge(expectSubmit());
        scene.expect(CpAck.class);
        scene.told.clear();
        delivered(1, report(id, 0x00));
        int other = scene.station.sendMessage(Scene.OTHER, "hello");
        scene.acceptService();
        acknowledge(expectSubmit());
        scene.expect(CpAck.class);
        scene.told.clear();
        delivered(2, report(other, 0x46));
        delivered(3, report(other, 0x00));
        assertEquals(List.of(), scene.told.lines());
    }

    @Test
    void aMessageMayComeDuringACall() {
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        scene.expect(Setup.class);
        scene.told.clear();
        delivered(1, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola"), scene.told.lines());
    }

    @Test
    void aBroadcastIsShownOnceHoweverOftenItsPagesCome() {
        String text = "Fire drill at noon. ".repeat(7);
        List<CellBroadcastPage> pages =
                CellBroadcast.split(text, 50, BroadcastSerial.ofValue(0x4011), Optional.empty());
        for (int round = 0; round < 2; round++) {
            pages.forEach(page -> scene.rsl(new RslMessage.SmsBroadcastCommand(page.encode())));
        }
        assertEquals(List.of("broadcast 50 in 2: " + text), scene.told.lines());
    }

    @Test
    void aPhoneThatIsOffShowsNoBroadcast() {
        scene.station.powerOff();
        scene.told.clear();
        CellBroadcast.split("x", 50, BroadcastSerial.ofValue(0x4011), Optional.empty())
                .forEach(page -> scene.rsl(new RslMessage.SmsBroadcastCommand(page.encode())));
        assertEquals(List.of(), scene.told.lines());
    }
}
