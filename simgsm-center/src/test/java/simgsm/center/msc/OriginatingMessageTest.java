package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage;
import simgsm.air.MobilityManagement;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.smsc.MessageState;
import simgsm.octets.OctetString;

/** Short messages from mobiles to the centre. */
class OriginatingMessageTest extends MessageStage {
    @Test
    void theSenderIsAcknowledgedOnlyOnceTheMessageIsStored() {
        network.commitsAtOnce = false;
        TestMobile sender = network.attach("5550100");
        TestMobile receiver = network.attach("5550200");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, submit("5550200", "hello"));
        sender.next(ShortMessageControl.CpAck.class);
        network.passSeconds(5);
        assertTrue(sender.hasNothing() && receiver.hasNothing(), "stored first, then acknowledged and sent on");
        network.commitAll(true);
        sender.next(ShortMessageControl.CpData.class);
        receiver.next(RslMessage.PagingCommand.class);
    }

    @Test
    void aStoreThatFailsRefusesTheMessageWithCause38() {
        network.commitsAtOnce = false;
        TestMobile sender = network.attach("5550100");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, submit("5550200", "hello"));
        sender.next(ShortMessageControl.CpAck.class);
        network.commitAll(false);
        assertEquals(
                new RelayMessage.RpError(9, RpCause.NETWORK_OUT_OF_ORDER),
                sender.next(ShortMessageControl.CpData.class).relay());
        assertEquals(List.of(MessageState.REJECTED), states());
        assertEquals(0, network.exchange.shortMessages().waitingCount());
    }

    @Test
    void aRepeatedCpDataIsAcknowledgedAndNotAcceptedTwice() {
        network.commitsAtOnce = false;
        TestMobile sender = network.attach("5550100");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, submit("5550200", "once"));
        sender.sendMessage(0, 9, submit("5550200", "once"));
        sender.next(ShortMessageControl.CpAck.class);
        sender.next(ShortMessageControl.CpAck.class);
        network.commitAll(true);
        sender.next(ShortMessageControl.CpData.class);
        assertTrue(sender.hasNothing());
        assertEquals(1, network.exchange.shortMessages().waitingCount());
    }

    private void giveUpAnswering(TestMobile sender) {
        network.passSeconds(90);
        for (int i = 0; i < 3; i++) {
            sender.next(ShortMessageControl.CpData.class);
        }
    }

    @Test
    void aCpDataThatComesAfterItsTransactionWasGivenUpIsAcknowledgedAndNotAcceptedTwice() {
        TestMobile sender = network.attach("5550100");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, submit("5550200", "hello"));
        sender.next(ShortMessageControl.CpAck.class);
        giveUpAnswering(sender);
        sender.leaveReleasedChannel();
        send(sender, submit("5550200", "hello"));
        assertEquals(1, network.exchange.shortMessages().waitingCount());
        send(sender, submit("5550200", "hello"));
        assertEquals(
                2, network.exchange.shortMessages().waitingCount(), "whose answer was confirmed cannot come again");
    }

    @Test
    void aMessageIsSentThoughItsSenderVanishesBeforeTheAcknowledgement() {
        network.commitsAtOnce = false;
        TestMobile sender = network.attach("5550100");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, submit("5550200", "hello"));
        sender.vanish();
        network.commitAll(true);
        assertEquals(List.of(MessageState.ACCEPTED), states());
    }

    @Test
    void aTransferUnitThatIsNoSubmitIsRefused() {
        TestMobile sender = network.attach("5550100");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, OctetString.ofHex("ff"));
        sender.next(ShortMessageControl.CpAck.class);
        assertTrue(sender.next(ShortMessageControl.CpData.class).relay() instanceof RelayMessage.RpError);
        sender.tell(new ShortMessageControl.CpAck(FIRST));
        sender.leaveReleasedChannel();
        assertTrue(network.stored.isEmpty());
    }

    @Test
    void anAnswerFromTheNetworksSideIsNoMessage() {
        TestMobile sender = network.attach("5550100");
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.tell(new ShortMessageControl.CpData(FIRST, new RelayMessage.RpAck(1, Optional.empty())));
        sender.next(ShortMessageControl.CpAck.class);
        assertEquals(
                new RelayMessage.RpError(1, RpCause.MESSAGE_NOT_COMPATIBLE),
                sender.next(ShortMessageControl.CpData.class).relay());
    }

    @Test
    void transactionsThatAreNotThereGetCpError81() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        mobile.tell(new ShortMessageControl.CpData(
                new TransactionIdentifier(3, true), new RelayMessage.RpAck(1, Optional.empty())));
        assertEquals(81, mobile.next(ShortMessageControl.CpError.class).cause());
        mobile.tell(new ShortMessageControl.CpAck(new TransactionIdentifier(3, true)));
        mobile.tell(new ShortMessageControl.CpError(new TransactionIdentifier(3, true), 81));
        mobile.tell(new ShortMessageControl.CpAck(FIRST));
        assertTrue(mobile.hasNothing());
    }

    @Test
    void aMessageWithoutServiceGetsCpError98() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().sendMessage(0, 9, submit("5550200", "hello"));
        assertEquals(98, call.caller().next(ShortMessageControl.CpError.class).cause());
    }
}
