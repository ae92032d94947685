package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage;
import simgsm.air.MobilityManagement;
import simgsm.air.RadioResource;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.smsc.MessageState;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.ValidityPeriod;

/** Short messages from the centre to mobiles, and their reports. */
class TerminatingMessageTest extends MessageStage {
    @Test
    void aMessageIsAcknowledgedAndDeliveredAtOnce() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "** #**20 **"));
        receiver.answerPaging();
        DeliverTpdu deliver = (DeliverTpdu) decode(receiver.takeMessage());
        assertEquals("5550100", deliver.originator().value());
        assertEquals("** #**20 **", deliver.userData().text());
        assertEquals(TestNetwork.START, deliver.timestamp().toOffsetDateTime().toInstant());
        assertFalse(deliver.moreMessages());
        receiver.leaveReleasedChannel();
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.DELIVERED), states());
        assertEquals(2, network.stored.size());
        assertTrue(network.exchange.shortMessages().messages().waiting().isEmpty());
    }

    @Test
    void aMessageToADetachedReceiverWaitsAndIsDeliveredWhenItAttaches() {
        TestMobile sender = network.attach("5550100");
        send(sender, submit("5550200", "first"));
        send(sender, submit("5550200", "second"));
        assertEquals(2, network.exchange.shortMessages().messages().waiting().size());
        network.passSeconds(3_600);
        TestMobile receiver = network.attach("5550200");
        receiver.answerPaging();
        OctetString first = receiver.takeMessage();
        assertEquals("first", textOf(first));
        assertTrue(((DeliverTpdu) decode(first)).moreMessages());
        assertEquals("second", textOf(receiver.takeMessage()), "on the same radio connection");
        receiver.leaveReleasedChannel();
    }

    @Test
    void manyMessagesArriveInTheOrderOfSending() {
        TestMobile sender = network.attach("5550100");
        List<String> sent = new ArrayList<>();
        for (int i = 0; i < 300; i++) {
            sent.add("number " + i);
            send(sender, submit("5550200", "number " + i));
        }
        TestMobile receiver = network.attach("5550200");
        receiver.answerPaging();
        List<String> got = new ArrayList<>();
        for (int i = 0; i < 300; i++) {
            got.add(textOf(receiver.takeMessage()));
        }
        assertEquals(sent, got);
    }

    @Test
    void aMessageToOneselfComesBack() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        mobile.sendMessage(0, 9, submit("5550100", "note"));
        mobile.next(ShortMessageControl.CpAck.class);
        mobile.next(ShortMessageControl.CpData.class);
        assertEquals("note", textOf(mobile.takeMessage()));
        mobile.tell(new ShortMessageControl.CpAck(FIRST));
        mobile.leaveReleasedChannel();
    }

    @Test
    void aMessageReachesAMobileThatIsInACall() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        TestMobile third = network.attach("5550101");
        send(third, submit("5550200", "psst"));
        assertEquals("psst", textOf(call.called().takeMessage()));
        assertTrue(call.called().hasNothing(), "the channel stays for the call");
    }

    @Test
    void aMobileThatDoesNotAcknowledgeIsSentTheMessageThreeTimesAndTriedAgainLater() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "hello"));
        receiver.answerPaging();
        receiver.next(ShortMessageControl.CpData.class);
        network.passSeconds(10);
        receiver.next(ShortMessageControl.CpData.class);
        network.passSeconds(10);
        receiver.next(ShortMessageControl.CpData.class);
        network.passSeconds(10);
        receiver.leaveReleasedChannel();
        network.passSeconds(59);
        assertTrue(receiver.hasNothing());
        network.passSeconds(1);
        receiver.answerPaging();
        assertEquals("hello", textOf(receiver.takeMessage()));
    }

    @Test
    void aMobileThatNeverConfirmsTheMessageIsGivenUpAfter40Seconds() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "hello"));
        receiver.answerPaging();
        ShortMessageControl.CpData data = receiver.next(ShortMessageControl.CpData.class);
        receiver.tell(new ShortMessageControl.CpAck(data.transaction().answered()));
        network.passSeconds(40);
        receiver.leaveReleasedChannel();
        assertEquals(List.of(MessageState.ACCEPTED), states());
    }

    @Test
    void aFullMemoryWaitsForItsRoom() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "hello"));
        receiver.answerPaging();
        refuse(receiver, RpCause.MEMORY_CAPACITY_EXCEEDED);
        receiver.leaveReleasedChannel();
        send(sender, submit("5550200", "again"));
        assertTrue(receiver.hasNothing());
        // RP-SMMA: there is room now.
        receiver.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        receiver.tell(new ShortMessageControl.CpData(FIRST, new RelayMessage.RpSmma(3)));
        receiver.next(ShortMessageControl.CpAck.class);
        assertEquals(
                new RelayMessage.RpAck(3, Optional.empty()),
                receiver.next(ShortMessageControl.CpData.class).relay());
        assertEquals("hello", textOf(receiver.takeMessage()));
        assertEquals("again", textOf(receiver.takeMessage()));
    }

    private static void refuse(TestMobile receiver, RpCause cause) {
        ShortMessageControl.CpData data = receiver.next(ShortMessageControl.CpData.class);
        TransactionIdentifier transaction = data.transaction().answered();
        receiver.tell(new ShortMessageControl.CpAck(transaction));
        receiver.tell(new ShortMessageControl.CpData(
                transaction, new RelayMessage.RpError(data.relay().reference(), cause)));
        receiver.next(ShortMessageControl.CpAck.class);
    }

    @Test
    void aMessageThatTheReceiverRefusesIsRejectedAndTheNextOneTried() {
        TestMobile sender = network.attach("5550100");
        send(sender, submit("5550200", "bad"));
        send(sender, submit("5550200", "good"));
        TestMobile receiver = network.attach("5550200");
        receiver.answerPaging();
        refuse(receiver, RpCause.PROTOCOL_ERROR);
        assertEquals("good", textOf(receiver.takeMessage()));
        assertEquals(
                List.of(MessageState.ACCEPTED, MessageState.ACCEPTED, MessageState.REJECTED, MessageState.DELIVERED),
                states());
    }

    @Test
    void aReceiverThatVanishesInTheMiddleGetsTheMessageWhenItComesBack() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "hello"));
        receiver.answerPaging();
        receiver.next(ShortMessageControl.CpData.class);
        receiver.vanish();
        TestMobile back = network.connect("5550200", receiver.imei).register();
        back.answerPaging();
        assertEquals("hello", textOf(back.takeMessage()));
    }

    @Test
    void unansweredPagingIsTriedAgainByTheSchedule() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "hello"));
        for (int i = 0; i < 3; i++) {
            receiver.next(RslMessage.PagingCommand.class);
            network.passSeconds(3);
        }
        assertTrue(receiver.hasNothing());
        network.passSeconds(60);
        receiver.answerPaging();
        assertEquals("hello", textOf(receiver.takeMessage()));
    }

    @Test
    void aMessageWhoseValidityEndsIsExpired() {
        TestMobile sender = network.attach("5550100");
        // Relative validity 0: five minutes.
        send(sender, submit("5550200", "late", false, Optional.of(new ValidityPeriod.Relative(0))));
        send(sender, submit("5550200", "patient"));
        network.passSeconds(300);
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.ACCEPTED, MessageState.EXPIRED), states());
        TestMobile receiver = network.attach("5550200");
        receiver.answerPaging();
        assertEquals("patient", textOf(receiver.takeMessage()));
    }

    @Test
    void aRequestedReportGoesBackToTheSender() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        send(sender, submit("5550200", "hello", true, Optional.empty()));
        receiver.answerPaging();
        receiver.takeMessage();
        sender.answerPaging();
        StatusReportTpdu report = (StatusReportTpdu) decode(sender.takeMessage());
        assertEquals(7, report.reference());
        assertEquals("5550200", report.recipient().value());
        assertEquals(DeliveryStatus.DELIVERED, report.status());
        sender.leaveReleasedChannel();
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.DELIVERED), states(), "reports make no events");
    }

    @Test
    void theChannelIsReleasedOnlyWhenTheLastTransactionIsOver() {
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        receiver.dial("5550999");
        receiver.next(simgsm.air.CallControl.ReleaseComplete.class);
        receiver.next(RadioResource.ChannelRelease.class);
        send(sender, submit("5550200", "hello"));
        assertTrue(receiver.hasNothing(), "not paged while it leaves the old channel");
        receiver.leaveChannel();
        receiver.answerPaging();
        receiver.takeMessage();
        receiver.leaveReleasedChannel();
    }
}
