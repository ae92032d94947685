package simgsm.center.smpp;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.message;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.with;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.center.smsc.Destination;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.Tlv;

/** Messages in, and out again. */
class SmppDeliveryTest extends SmppStage {
    @Test
    void theAnswerToASubmissionWaitsForTheStore() {
        TestCenter.Application sender = sender();
        sender.submit(7, text("1", SERVICE, "hello"));
        assertTrue(sender.heard.isEmpty());
        network.commit();
        SmppPdu.MessageResponse answer = sender.last(SmppPdu.MessageResponse.class);
        assertEquals(new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, SmppStatus.OK, 7, "1"), answer);
    }

    @Test
    void aStoreThatFailsIsASystemErrorAndNothingIsDelivered() {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(7, text("1", SERVICE, "hello"));
        network.center.committed(network.tickets.remove(), false);
        assertEquals(
                SmppStatus.SYSTEM_ERROR,
                sender.last(SmppPdu.MessageResponse.class).status());
        assertTrue(receiver.heard.isEmpty());
    }

    @Test
    void messagesReachTheApplicationThatServesTheirNumberInOrder() {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = sender();
        for (int i = 0; i < 50; i++) {
            sender.submit(i + 1, text("5550100", SERVICE, "m" + i));
        }
        network.commit();
        assertEquals(50, receiver.heard.size(), "within the window nothing waits for answers");
        for (int i = 0; i < 50; i++) {
            assertEquals("m" + i, texts(receiver).get(i));
        }
        SmppMessage first = receiver.all(SmppPdu.Message.class).get(0).message();
        assertEquals("5550100", first.source().value());
        assertEquals(SERVICE, first.destination().value());
    }

    @Test
    void aFullWindowHoldsTheRestBackUntilAnswersCome() {
        TestCenter.Application receiver = receiver("555*");
        TestCenter.Application sender = sender();
        int count = DeliveryWindow.SIZE + 60;
        for (int i = 0; i < count; i++) {
            sender.submit(i + 1, text("1", "55503" + i % 3, "m" + i));
        }
        network.commit();
        assertEquals(DeliveryWindow.SIZE, receiver.heard.size());
        for (int i = 0; i < receiver.heard.size(); i++) {
            receiver.answer((SmppPdu.Message) receiver.heard.get(i), SmppStatus.OK);
        }
        assertEquals(count, receiver.heard.size());
        assertEquals(
                count, List.copyOf(new java.util.HashSet<>(texts(receiver))).size(), "each once");
        network.commit();
        assertEquals(0, network.center.waitingCount());
    }

    @Test
    void aNewSessionTakesWhatWaitsForRoomBesideOneThatIsDeadUnnoticed() {
        TestCenter.Application dead = receiver("5550301");
        TestCenter.Application sender = sender();
        int count = DeliveryWindow.SIZE + 60;
        for (int i = 0; i < count; i++) {
            sender.submit(i + 1, text("1", "5550301", "m" + i));
        }
        network.commit();
        assertEquals(DeliveryWindow.SIZE, dead.heard.size());
        TestCenter.Application alive = receiver("5550301");
        assertEquals(60, alive.heard.size());
        dead.leave();
        for (int i = 0; i < alive.heard.size(); i++) {
            alive.answer((SmppPdu.Message) alive.heard.get(i), SmppStatus.OK);
        }
        assertEquals(count, alive.heard.size());
        network.commit();
        assertEquals(0, network.center.waitingCount());
    }

    @Test
    void whoWaitsForRoomGetsATurnBesideAFullQueue() {
        TestCenter.Application receiver = receiver("555*");
        TestCenter.Application sender = sender();
        for (int i = 0; i < 3 * DeliveryWindow.SIZE; i++) {
            sender.submit(i + 1, text("1", "5550301", "many"));
        }
        sender.submit(1_000, text("1", "5550302", "one"));
        network.commit();
        receiver.answer((SmppPdu.Message) receiver.heard.get(0), SmppStatus.OK);
        receiver.answer((SmppPdu.Message) receiver.heard.get(1), SmppStatus.OK);
        assertTrue(texts(receiver).contains("one"), "after at most two answers");
    }

    @Test
    void whatIsNotAnsweredIsTriedAgain() {
        TestCenter.Application receiver = receiver(SERVICE);
        sender().submit(1, text("1", SERVICE, "hello"));
        network.commit();
        assertEquals(1, receiver.heard.size());
        network.passSeconds(29);
        assertEquals(1, receiver.heard.size());
        network.passSeconds(1);
        network.passSeconds(59);
        receiver.heard.clear();
        network.passSeconds(2);
        assertEquals(List.of("hello"), texts(receiver));
    }

    @Test
    void aLateAnswerIsIgnored() {
        TestCenter.Application receiver = receiver(SERVICE);
        sender().submit(1, text("1", SERVICE, "hello"));
        network.commit();
        network.passSeconds(31);
        receiver.answer((SmppPdu.Message) receiver.heard.get(0), SmppStatus.OK);
        assertEquals(1, network.center.waitingCount());
    }

    @ParameterizedTest
    @CsvSource({"0x58, true", "0x14, true", "0x08, true", "0x64, true", "0x65, false", "0x66, false", "0x03, false"})
    void anApplicationsRefusalIsTriedAgainOnlyIfItMayPass(String status, boolean again) {
        TestCenter.Application receiver = receiver(SERVICE);
        sender().submit(1, text("1", SERVICE, "hello"));
        network.commit();
        receiver.answer((SmppPdu.Message) receiver.heard.get(0), Integer.decode(status));
        assertEquals(again ? 1 : 0, network.center.waitingCount());
        network.passSeconds(61);
        assertEquals(again ? 2 : 1, receiver.all(SmppPdu.Message.class).size());
    }

    @Test
    void whatASessionLeftUnansweredGoesToTheNextOneThatServesTheNumber() {
        TestCenter.Application first = receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", SERVICE, "a"));
        sender.submit(2, text("1", SERVICE, "b"));
        network.commit();
        first.leave();
        TestCenter.Application second = receiver(SERVICE);
        assertEquals(List.of("a", "b"), texts(second));
    }

    @Test
    void aSecondSessionOfTheSameApplicationTakesOverAtOnce() {
        TestCenter.Application first = receiver(SERVICE);
        TestCenter.Application second = receiver(SERVICE);
        TestCenter.Application sender = sender();
        for (int i = 0; i < 4; i++) {
            sender.submit(i + 1, text("1", SERVICE, "m" + i));
        }
        network.commit();
        assertEquals(2, first.heard.size(), "shared evenly");
        assertEquals(2, second.heard.size());
        first.leave();
        assertEquals(4, second.heard.size());
    }

    @Test
    void theClosestRangeGetsTheMessage() {
        TestCenter.Application all = network.bound(SmppCommand.BIND_RECEIVER, "all", "5.*");
        TestCenter.Application prefix = network.bound(SmppCommand.BIND_RECEIVER, "prefix", "5553*");
        TestCenter.Application longer = network.bound(SmppCommand.BIND_RECEIVER, "longer", "^55533");
        TestCenter.Application exact = network.bound(SmppCommand.BIND_RECEIVER, "exact", "5553399");
        TestCenter.Application sender = sender();
        for (String number : List.of("5554000", "5553100", "5553311", "5553399")) {
            sender.submit(1, text("1", number, number));
        }
        network.commit();
        assertEquals(List.of("5554000"), texts(all));
        assertEquals(List.of("5553100"), texts(prefix));
        assertEquals(List.of("5553311"), texts(longer));
        assertEquals(List.of("5553399"), texts(exact));
    }

    @Test
    void aWindowThatTheResponseTimerHasFreedServesTheOtherReceiversAtOnce() {
        network.server.admit(SmppUsers.only(Map.of("receiver", "", "receiver.window", "5", "sender", "")));
        TestCenter.Application receiver = receiver("555*");
        TestCenter.Application sender = sender();
        for (int i = 0; i < 5; i++) {
            sender.submit(i + 1, text("1", "5550301", "unanswered"));
        }
        sender.submit(1_000, text("1", "5550302", "one"));
        network.commit();
        assertFalse(texts(receiver).contains("one"), "the window is full");
        network.passSeconds(30);
        assertTrue(texts(receiver).contains("one"));
    }

    private static SmppMessage threeParts() {
        return with(
                text("1", SERVICE, ""),
                "",
                1,
                List.of(new Tlv(
                        Tlv.MESSAGE_PAYLOAD, OctetString.of("a".repeat(400).getBytes(US_ASCII)))));
    }

    @Test
    void aLongMessageForWhichThereIsNoRoomInFullIsRefusedInFull() {
        TestCenter.Application sender = sender();
        for (int i = 0; i < 49_998; i++) {
            sender.submit(i + 1, text("1", SERVICE, "x"));
        }
        sender.submit(50_000, threeParts());
        assertEquals(
                new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, SmppStatus.QUEUE_FULL, 50_000, ""),
                sender.last(SmppPdu.MessageResponse.class));
        network.commit();
        assertEquals(49_998, network.center.waitingCount(), "no part of it waits");
        sender.submit(50_001, threeParts());
        network.commit();
        assertEquals(50_001, network.center.waitingCount());
    }

    @Test
    void theStoreTakesALongMessageInFullOrNotAtAll() {
        TestCenter.Application sender = sender();
        sender.submit(1, threeParts());
        assertEquals(1, network.tickets.size());
        network.center.committed(network.tickets.remove(), false);
        assertEquals(
                SmppStatus.SYSTEM_ERROR,
                sender.last(SmppPdu.MessageResponse.class).status());
        assertEquals(0, network.center.waitingCount());
        sender.submit(2, threeParts());
        network.commit();
        assertEquals(
                new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, SmppStatus.OK, 2, "6"),
                sender.last(SmppPdu.MessageResponse.class));
        assertEquals(3, network.center.waitingCount());
    }

    @Test
    void aReceiverWhoseMessagesAreAllCancelledIsNotRememberedAsBlocked() {
        receiver("555*");
        TestCenter.Application sender = sender();
        for (int i = 0; i < DeliveryWindow.SIZE; i++) {
            sender.submit(i + 1, text("1", "5550301", "unanswered"));
        }
        network.commit();
        for (int i = 0; i < 1_000; i++) {
            sender.submit(1, text("1", "555" + i, "x"));
            network.commit();
            String id = sender.last(SmppPdu.MessageResponse.class).messageId();
            sender.say(new SmppPdu.Cancel(2, "", id, SmppAddress.NONE, SmppAddress.NONE));
            assertEquals(SmppStatus.OK, sender.last(SmppPdu.PlainResponse.class).status());
        }
        assertEquals(0, network.server.routes().blocked(new Destination.Number(new Msisdn("5550301"))));
    }

    @Test
    void messagesWaitForAnApplicationThatComesLater() {
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", "5553100", "early"));
        network.commit();
        assertEquals(List.of("early"), texts(receiver("^555.*$")));
    }

    @ParameterizedTest
    @CsvSource({"999, 0x61", "000000000100000R, 0", "261121130000000+, 0", "261121115959000+, 0x62", "2611211300, 0x62"
    })
    void validityIsRelativeOrAbsoluteAndLiesAhead(String validity, String status) {
        TestCenter.Application sender = sender();
        sender.submit(1, with(text("1", SERVICE, "x"), validity, 0, List.of()));
        network.commit();
        int expected = validity.equals("999") ? SmppStatus.INVALID_VALIDITY : Integer.decode(status);
        int found = sender.last(SmppPdu.class) instanceof SmppPdu.MessageResponse response
                ? response.status()
                : sender.last(SmppPdu.PlainResponse.class).status();
        assertEquals(expected, found);
    }

    @Test
    void aFullQueueRefusesTheSendersMessage() {
        TestCenter.Application sender = sender();
        for (int i = 0; i < 200_000; i++) {
            sender.submit(i, message("1", SERVICE, 0, 0, new byte[] {0x41}));
            network.commit();
            sender.heard.clear();
        }
        sender.submit(5, text("1", SERVICE, "one too many"));
        assertEquals(
                new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, SmppStatus.QUEUE_FULL, 5, ""),
                sender.last(SmppPdu.MessageResponse.class));
    }
}
