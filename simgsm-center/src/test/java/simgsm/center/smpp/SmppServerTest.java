package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.message;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.with;
import static simgsm.center.smpp.SmppClient.withReceipt;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.Msisdn;
import simgsm.air.OctetString;

/** Applications and the centre, with time moved by hand. */
class SmppServerTest {
    private static final String SERVICE = "5550300";

    private final TestCenter network = new TestCenter();

    private TestCenter.Application receiver(String range) {
        return network.bound(Command.BIND_RECEIVER, "receiver", range);
    }

    private TestCenter.Application sender() {
        return network.bound(Command.BIND_TRANSMITTER, "sender", "");
    }

    private static String textOf(SmppPdu.Message delivery) {
        return new String(delivery.message().shortMessage().toArray(), StandardCharsets.ISO_8859_1);
    }

    private static List<String> texts(TestCenter.Application application) {
        return application.all(SmppPdu.Message.class).stream()
                .map(SmppServerTest::textOf)
                .toList();
    }

    @Test
    void theAnswerToASubmissionWaitsForTheStore() {
        TestCenter.Application sender = sender();
        sender.submit(7, text("1", SERVICE, "hello"));
        assertTrue(sender.heard.isEmpty());
        network.commit();
        SmppPdu.MessageResponse answer = sender.last(SmppPdu.MessageResponse.class);
        assertEquals(new SmppPdu.MessageResponse(Command.SUBMIT_SM, SmppStatus.OK, 7, "1"), answer);
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
        TestCenter.Application all = network.bound(Command.BIND_RECEIVER, "all", "[0-9]+");
        TestCenter.Application prefix = network.bound(Command.BIND_RECEIVER, "prefix", "5553*");
        TestCenter.Application longer = network.bound(Command.BIND_RECEIVER, "longer", "^55533");
        TestCenter.Application exact = network.bound(Command.BIND_RECEIVER, "exact", "5553399");
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
    void messagesWaitForAnApplicationThatComesLater() {
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", "5553100", "early"));
        network.commit();
        assertEquals(List.of("early"), texts(receiver("555[0-9]{4}")));
    }

    @Test
    void aReceiptSaysWhatBecameOfTheMessage() {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = network.bound(Command.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, withReceipt(text("5550100", SERVICE, "how do you do, dear reader?")));
        network.commit();
        network.passSeconds(20);
        receiver.answer(receiver.all(SmppPdu.Message.class).get(0), SmppStatus.OK);
        network.commit();
        SmppMessage receipt = sender.last(SmppPdu.Message.class).message();
        assertEquals(SmppMessage.RECEIPT, receipt.esmClass());
        assertEquals(
                "id:1 sub:001 dlvrd:001 submit date:2611211200 done date:2611211201 stat:DELIVRD err:000"
                        + " text:how do you do, dear ",
                textOf(sender.last(SmppPdu.Message.class)));
        assertEquals(SERVICE, receipt.source().value());
        assertEquals("5550100", receipt.destination().value());
        assertEquals(
                List.of(new Tlv(0x001e, OctetString.ofHex("3100")), new Tlv(0x0427, OctetString.ofHex("02"))),
                receipt.parameters());
    }

    @Test
    void aReceiptWaitsForAnApplicationThatOnlySends() {
        receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(1, with(withReceipt(text("1", "5559999", "x")), "000000000100000R", 1, List.of()));
        network.commit();
        network.passSeconds(61);
        network.commit();
        assertEquals(1, sender.all(SmppPdu.Message.class).size() + network.center.waitingCount());
        TestCenter.Application fetching = network.bound(Command.BIND_RECEIVER, "sender", "");
        assertTrue(
                texts(fetching).get(0).contains("stat:EXPIRED err:070"),
                texts(fetching).get(0));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "1, 1, 1", "2, 0, 1"})
    void receiptsComeAsTheyWereAskedFor(int registered, int onDelivery, int onFailure) {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = network.bound(Command.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, with(text("1", SERVICE, "x"), "", registered, List.of()));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), SmppStatus.OK);
        network.commit();
        assertEquals(onDelivery, sender.all(SmppPdu.Message.class).size());
        sender.heard.clear();
        sender.submit(2, with(text("1", SERVICE, "x"), "", registered, List.of()));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), 0x65);
        network.commit();
        assertEquals(onFailure, sender.all(SmppPdu.Message.class).size());
    }

    @Test
    void aMessageThatWaitsCanBeAskedAboutAndCalledBack() {
        TestCenter.Application sender = network.bound(Command.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, withReceipt(text("5550100", SERVICE, "x")));
        network.commit();
        SmppAddress source = new SmppAddress(1, 1, "5550100");
        sender.say(new SmppPdu.Query(2, "1", source));
        assertEquals(
                new SmppPdu.QueryResponse(SmppStatus.OK, 2, "1", "", 1, 0), sender.last(SmppPdu.QueryResponse.class));
        sender.say(new SmppPdu.Cancel(3, "1", source, new SmppAddress(1, 1, SERVICE)));
        network.commit();
        assertTrue(sender.heard.contains(new SmppPdu.PlainResponse(Command.CANCEL_SM, SmppStatus.OK, 3)));
        network.commit();
        assertTrue(sender.all(SmppPdu.Message.class).stream()
                .anyMatch(each -> textOf(each).contains("stat:DELETED")));
        sender.say(new SmppPdu.Query(4, "1", source));
        SmppPdu.QueryResponse answer = sender.last(SmppPdu.QueryResponse.class);
        assertEquals(4, answer.state());
        assertEquals("261121120045000+", answer.finalDate());
        assertEquals(List.of(), texts(receiver(SERVICE)));
    }

    @Test
    void nobodyHearsOfTheMessagesOfOthers() {
        sender().submit(1, text("5550100", SERVICE, "x"));
        network.commit();
        TestCenter.Application other = network.bound(Command.BIND_TRANSMITTER, "other", "");
        other.say(new SmppPdu.Query(1, "1", SmppAddress.NONE));
        assertEquals(
                SmppStatus.QUERY_FAILED, other.last(SmppPdu.PlainResponse.class).status());
        other.say(new SmppPdu.Cancel(2, "1", SmppAddress.NONE, SmppAddress.NONE));
        assertEquals(
                SmppStatus.CANCEL_FAILED,
                other.last(SmppPdu.PlainResponse.class).status());
        other.say(new SmppPdu.Query(3, "no number", SmppAddress.NONE));
        assertEquals(
                SmppStatus.QUERY_FAILED, other.last(SmppPdu.PlainResponse.class).status());
    }

    @Test
    void aMessageUnderWayCannotBeCalledBack() {
        receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", SERVICE, "x"));
        network.commit();
        sender.say(new SmppPdu.Cancel(2, "1", SmppAddress.NONE, SmppAddress.NONE));
        assertEquals(
                SmppStatus.CANCEL_FAILED,
                sender.last(SmppPdu.PlainResponse.class).status());
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

    @ParameterizedTest
    @EnumSource(Command.class)
    void aRequestInTheWrongStateIsAnsweredWithStatus4(Command command) {
        TestCenter.Application open = network.open(true);
        if (command.isBind() || command == Command.ENQUIRE_LINK) {
            return;
        }
        SmppPdu pdu = switch (command) {
            case QUERY_SM -> new SmppPdu.Query(5, "1", SmppAddress.NONE);
            case CANCEL_SM -> new SmppPdu.Cancel(5, "1", SmppAddress.NONE, SmppAddress.NONE);
            case UNBIND -> new SmppPdu.Plain(command, 5);
            default -> new SmppPdu.Message(command, 5, text("1", "2", "x"));
        };
        open.say(pdu);
        byte[] answer = SmppCodec.encode(open.last(SmppPdu.class));
        assertEquals(16, answer.length);
        assertEquals(SmppStatus.INVALID_BIND_STATUS, answer[11]);
        assertEquals(5, answer[15]);
    }

    @Test
    void whoIsBoundCannotBindAgainAndAReceiverCannotSend() {
        TestCenter.Application receiver = receiver(SERVICE);
        receiver.say(new SmppPdu.Bind(Command.BIND_TRANSMITTER, 2, "x", "", "", 0x34, ""));
        assertEquals(
                SmppStatus.ALREADY_BOUND,
                receiver.last(SmppPdu.BindResponse.class).status());
        receiver.submit(3, text("1", "2", "x"));
        assertEquals(
                SmppStatus.INVALID_BIND_STATUS,
                receiver.last(SmppPdu.MessageResponse.class).status());
    }

    @Test
    void onlyListedApplicationsBindWithTheirPassword() {
        network.server.admit(SmppUsers.only(Map.of("robot", "secret")));
        TestCenter.Application application = network.open(false);
        assertEquals(SmppStatus.INVALID_SYSTEM_ID, bind(application, "nobody", "secret"));
        assertEquals(SmppStatus.INVALID_PASSWORD, bind(application, "robot", "guess"));
        assertEquals(SmppStatus.OK, bind(application, "robot", "secret"));
    }

    @Test
    void withoutAListOnlyThisMachineMayBind() {
        assertEquals(SmppStatus.BIND_FAILED, bind(network.open(false), "robot", ""));
        assertEquals(SmppStatus.OK, bind(network.open(true), "robot", "anything"));
    }

    @Test
    void guessingPasswordsEndsTheConnection() {
        network.server.admit(SmppUsers.only(Map.of("robot", "secret")));
        TestCenter.Application application = network.open(true);
        for (int i = 0; i < EsmeSession.MAX_REFUSED_BINDS; i++) {
            assertFalse(application.isEnding);
            assertEquals(SmppStatus.INVALID_PASSWORD, bind(application, "robot", "guess" + i));
        }
        assertTrue(application.isEnding);
    }

    private static int bind(TestCenter.Application application, String systemId, String password) {
        application.say(new SmppPdu.Bind(Command.BIND_TRANSCEIVER, 1, systemId, password, "", 0x34, ""));
        return application.last(SmppPdu.BindResponse.class).status();
    }

    @Test
    void aRangeThatIsNoneRefusesTheBind() {
        TestCenter.Application application = network.open(true);
        application.say(new SmppPdu.Bind(Command.BIND_RECEIVER, 1, "x", "", "", 0x34, "[1-"));
        assertEquals(
                SmppStatus.BIND_FAILED,
                application.last(SmppPdu.BindResponse.class).status());
    }

    @Test
    void aSilentApplicationIsAskedAndThenClosed() {
        TestCenter.Application application = receiver(SERVICE);
        network.passSeconds(60);
        assertEquals(Command.ENQUIRE_LINK, application.last(SmppPdu.Plain.class).command());
        application.say(new SmppPdu.PlainResponse(
                Command.ENQUIRE_LINK,
                SmppStatus.OK,
                application.last(SmppPdu.Plain.class).sequence()));
        network.passSeconds(59);
        assertEquals("", application.closed);
        network.passSeconds(1);
        network.passSeconds(30);
        assertEquals("does not answer enquire_link", application.closed);
    }

    @Test
    void whoDoesNotBindIsClosed() {
        TestCenter.Application application = network.open(true);
        network.passSeconds(30);
        assertEquals("does not bind", application.closed);
    }

    @Test
    void unbindIsAnsweredAndEndsTheConnection() {
        TestCenter.Application application = receiver(SERVICE);
        application.say(new SmppPdu.Plain(Command.UNBIND, 9));
        assertEquals(
                new SmppPdu.PlainResponse(Command.UNBIND, SmppStatus.OK, 9),
                application.last(SmppPdu.PlainResponse.class));
        assertTrue(application.isEnding);
        assertFalse(network.server.routes().serve(new Msisdn(SERVICE)));
    }

    @Test
    void anApplicationElsewhereIsThrottledAndOneHereIsNot() {
        network.server.admit(SmppUsers.only(Map.of("far", "", "near", "")));
        TestCenter.Application far = network.open(false);
        bind(far, "far", "");
        TestCenter.Application near = network.open(true);
        bind(near, "near", "");
        for (int i = 0; i <= Throttle.MAX_UNANSWERED; i++) {
            far.submit(i, text("1", SERVICE, "x"));
            near.submit(i, text("1", SERVICE, "x"));
        }
        assertEquals(
                SmppStatus.THROTTLED, far.last(SmppPdu.MessageResponse.class).status());
        assertEquals(1, far.all(SmppPdu.MessageResponse.class).size());
        assertEquals(0, near.all(SmppPdu.MessageResponse.class).size());
    }

    @Test
    void whenAQueueIsFullTheSenderIsToldSo() {
        TestCenter.Application sender = sender();
        for (int i = 0; i < 200_000; i++) {
            sender.submit(i, message("1", SERVICE, 0, 0, new byte[] {0x41}));
            network.commit();
            sender.heard.clear();
        }
        sender.submit(5, text("1", SERVICE, "one too many"));
        assertEquals(
                new SmppPdu.MessageResponse(Command.SUBMIT_SM, SmppStatus.QUEUE_FULL, 5, ""),
                sender.last(SmppPdu.MessageResponse.class));
    }

    @Test
    void aThousandApplicationsAreHeld() {
        for (int i = 0; i < 1_000; i++) {
            network.bound(Command.BIND_TRANSCEIVER, "app" + i, "" + (5_000_000 + i));
        }
        assertEquals(1_000, network.server.boundSessions());
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", "5000777", "x"));
        network.commit();
        assertEquals(0, network.center.waiting().size() - 1);
    }
}
