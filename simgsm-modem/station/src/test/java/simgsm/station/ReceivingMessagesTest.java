package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.CallControl.Setup;
import simgsm.air.RelayMessage;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.MessageSplitter;
import simgsm.sms.SmsAddress;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.station.context.StationIdentity;

/** What a station is brought. */
class ReceivingMessagesTest extends MessageStage {
    @Test
    void aDeliveredMessageIsAcknowledgedAndReportedOnce() {
        openForDelivery();
        delivered(7, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
        scene.releaseChannel();
    }

    @Test
    void twoMessagesAlikeAreTwo() {
        openForDelivery();
        delivered(1, deliver(UserData.of("hola")));
        delivered(2, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola", "message from 5550200: hola"), scene.reported.lines());
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
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
    }

    @Test
    void aTextThatTheUserAnswersLaterIsAcknowledgedThenAndAnotherIsRefusedMeanwhile() {
        scene.station.answerMessagesLater();
        openForDelivery();
        down(1, deliver(UserData.of("first")));
        scene.expect(CpAck.class);
        scene.expectNothing();
        down(2, deliver(UserData.of("second")));
        scene.expect(CpAck.class);
        RpError refusal =
                assertInstanceOf(RpError.class, scene.expect(CpData.class).relay());
        assertEquals(RpCause.MEMORY_CAPACITY_EXCEEDED, refusal.cause());
        down(3, deliver(UserData.of("first")));
        scene.expect(CpAck.class);
        scene.station.messageTaken();
        assertInstanceOf(RpAck.class, scene.expect(CpData.class).relay());
        assertEquals(List.of("message from 5550200: first"), scene.reported.lines());
    }

    @Test
    void aMessageThatComesAgainOverANewLinkIsAcknowledgedButNotReported() {
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
                scene.reported.lines());
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
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
    }

    @Test
    void aMessageWhoseAcknowledgementTheNetworkRefusesMayComeAgain() {
        openForDelivery();
        OctetString tpdu = deliver(UserData.of("hola"));
        down(1, tpdu);
        scene.expect(CpAck.class);
        scene.expect(CpData.class);
        scene.down(new CpError(THEIRS, 81));
        delivered(2, tpdu);
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
    }

    @Test
    void aMessageThatComesAgainInANewTransactionBeforeItsAcknowledgementArrivedIsReportedOnce() {
        openForDelivery();
        OctetString tpdu = deliver(UserData.of("hola"));
        down(1, tpdu);
        scene.expect(CpAck.class);
        scene.expect(CpData.class);
        TransactionIdentifier next = new TransactionIdentifier(3, false);
        scene.down(new CpData(next, new RpData(2, StationIdentity.TEST_SERVICE_CENTER, tpdu)));
        scene.expect(new CpAck(next.answered()));
        scene.expect(new CpData(next.answered(), new RpAck(2, Optional.empty())));
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
    }

    @Test
    void partsAreJoinedInWhateverOrderTheyCome() {
        openForDelivery();
        String text = "abc".repeat(150);
        List<UserData> parts = MessageSplitter.split(text, 9);
        delivered(1, deliver(parts.get(2)));
        delivered(2, deliver(parts.get(0)));
        assertEquals(List.of(), scene.reported.lines());
        delivered(3, deliver(parts.get(1)));
        assertEquals(List.of("message from 5550200: " + text), scene.reported.lines());
    }

    @Test
    void aSenderWithANameIsReportedByIt() {
        openForDelivery();
        delivered(
                1,
                TpduCodec.encode(new DeliverTpdu(
                        false, false, false, SmsAddress.ofLetters("SimGSM"), 0, NOON, UserData.of("x"))));
        assertEquals(List.of("message from SimGSM: x"), scene.reported.lines());
    }

    @Test
    void aBrokenTransferUnitIsRefusedInRp() {
        openForDelivery();
        down(1, OctetString.ofHex("04ff91"));
        scene.expect(CpAck.class);
        RpError error = (RpError) scene.expect(CpData.class).relay();
        assertEquals(1, error.reference());
        assertTrue(List.of(96, 111).contains(error.cause().code()), error.toString());
        assertEquals(List.of(), scene.reported.lines());
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
    void aMessageMayComeDuringACall() {
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        scene.expect(Setup.class);
        scene.reported.clear();
        delivered(1, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
    }

    private void refused(int reference, OctetString tpdu) {
        down(reference, tpdu);
        scene.expect(new CpAck(THEIRS.answered()));
        scene.expect(new CpData(THEIRS.answered(), new RpError(reference, RpCause.MEMORY_CAPACITY_EXCEEDED)));
        scene.down(new CpAck(THEIRS));
    }

    @Test
    void aMessageThatFindsNoRoomIsRefusedWithCause22AndTheNetworkIsReportedWhenThereIsRoom() {
        scene.station.setMemoryAvailable(false);
        openForDelivery();
        refused(1, deliver(UserData.of("hola")));
        scene.releaseChannel();
        assertEquals(List.of(), scene.reported.lines());
        scene.station.setMemoryAvailable(true);
        scene.acceptService();
        CpData notice = scene.expect(CpData.class);
        assertInstanceOf(RelayMessage.RpSmma.class, notice.relay());
        acknowledge(notice);
        scene.expect(new CpAck(notice.transaction()));
        delivered(2, deliver(UserData.of("hola")));
        assertEquals(List.of("message from 5550200: hola"), scene.reported.lines());
    }

    @Test
    void withoutARefusalTheNetworkIsNotNotified() {
        scene.station.setMemoryAvailable(false);
        scene.station.setMemoryAvailable(true);
        scene.expectNothing();
    }

    @Test
    void aFullStationStillTakesStatusReports() {
        scene.station.setMemoryAvailable(false);
        openForDelivery();
        delivered(1, report(3, 0x00));
    }

    @Test
    void aFullStationAcknowledgesWhatItHasAlready() {
        openForDelivery();
        OctetString tpdu = deliver(UserData.of("hola"));
        delivered(1, tpdu);
        scene.linkDown();
        scene.station.setMemoryAvailable(false);
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        delivered(0, tpdu);
        refused(1, deliver(UserData.of("adios")));
    }

    @Test
    void theNoticeOfMemoryWaitsItsTurnBehindMessages() {
        scene.station.setMemoryAvailable(false);
        openForDelivery();
        refused(1, deliver(UserData.of("hola")));
        scene.releaseChannel();
        scene.station.sendMessage(Scene.OTHER, "first");
        scene.station.setMemoryAvailable(true);
        scene.station.setMemoryAvailable(false);
        scene.station.setMemoryAvailable(true);
        scene.acceptService();
        CpData message = scene.expect(CpData.class);
        assertInstanceOf(RpData.class, message.relay());
        acknowledge(message);
        scene.acceptService();
        scene.expect(new CpAck(message.transaction()));
        CpData notice = scene.expect(CpData.class);
        assertInstanceOf(RelayMessage.RpSmma.class, notice.relay());
        acknowledge(notice);
        scene.expect(new CpAck(notice.transaction()));
        scene.expectNothing();
    }

    @Test
    void aStationThatIsSwitchedOffForgetsTheNotice() {
        scene.station.setMemoryAvailable(false);
        openForDelivery();
        refused(1, deliver(UserData.of("hola")));
        scene.station.setMemoryAvailable(true);
        scene.station.powerOff();
        assertFalse(
                scene.reported.lines().contains("failed"),
                scene.reported.lines().toString());
    }
}
