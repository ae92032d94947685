package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.phone.store.Mailbox;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.phone.store.StoredMessage.Delivery;
import simgsm.station.context.StationEvent;

/** Messages in, out and broadcast, by console and by keys. */
class HandsetMessagesTest {
    private static final Msisdn ROBOT = new Msisdn("5550200");

    private static Delivery lastDelivery(Bench bench) {
        List<StoredMessage> outbox = bench.snapshot().in(MessageFolder.OUTBOX);
        return outbox.get(outbox.size() - 1).delivery();
    }

    @Test
    void aMessagesDeliveryIsMarkedStepByStep() {
        Bench bench = new Bench();
        bench.handset.sendMessage(ROBOT, "** #**20 **");
        assertEquals(Delivery.SENDING, lastDelivery(bench));
        bench.handset.accept(new StationEvent.MessageSent(0, ROBOT, 1));
        assertEquals(Delivery.SENT, lastDelivery(bench));
        bench.handset.accept(new StationEvent.MessageDelivered(0, ROBOT));
        assertEquals(Delivery.DELIVERED, lastDelivery(bench));
        assertEquals(List.of("sms-sent 5550200 1 0", "sms-delivered 5550200 0"), bench.events);
    }

    @Test
    void aMessageThatFailsIsMarked() {
        Bench bench = new Bench();
        bench.handset.sendMessage(ROBOT, "x");
        bench.handset.accept(new StationEvent.MessageFailed(0, ROBOT, RpCause.UNASSIGNED_NUMBER));
        assertEquals(Delivery.FAILED, lastDelivery(bench));
        assertEquals(List.of("sms-failed 5550200 1"), bench.events);
    }

    @Test
    void anEmptyTextIsRefused() {
        Bench bench = new Bench();
        assertEquals(Optional.of(Refusal.EMPTY_TEXT), bench.handset.sendMessage(ROBOT, ""));
        assertEquals(List.of(), bench.station.asked);
    }

    @Test
    void theInboxIsListedOldestFirstAndReadAfterwards() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        bench.handset.accept(new StationEvent.ShortMessageReceived("Robot", "4 Collision"));
        List<StoredMessage> first = bench.handset.readInbox();
        assertEquals(
                List.of("3 Done", "4 Collision"),
                first.stream().map(StoredMessage::text).toList());
        assertEquals(
                List.of(false, false), first.stream().map(StoredMessage::read).toList());
        assertEquals(
                List.of(true, true),
                bench.handset.readInbox().stream().map(StoredMessage::read).toList());
    }

    @Test
    void aBroadcastIsKeptInItsOwnBox() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.BroadcastReceived(50, 2, "storm"));
        assertEquals("50", bench.snapshot().in(MessageFolder.BROADCASTS).get(0).party());
        assertEquals(0, bench.snapshot().in(MessageFolder.INBOX).size());
        assertEquals(List.of("broadcast 50 storm"), bench.events);
    }

    @Test
    void beforeTheEndMessagesAreAcknowledged() {
        Bench bench = new Bench();
        bench.handset.sendMessage(ROBOT, "x");
        bench.handset.whenSettled(() -> bench.events.add("settled"));
        bench.handset.accept(new StationEvent.MessageSent(0, ROBOT, 1));
        assertEquals(List.of("sms-sent 5550200 1 0", "settled"), bench.events);
    }

    @Test
    void aTextIsWrittenWithTheKeysAndSent() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.MESSAGE, PhoneKey.FOUR, PhoneKey.FOUR, PhoneKey.RIGHT);
        bench.tap(PhoneKey.FOUR, PhoneKey.FOUR, PhoneKey.FOUR, PhoneKey.OK);
        bench.tap(PhoneKey.FIVE, PhoneKey.FIVE, PhoneKey.OK);
        assertEquals(List.of("sms 55 Hi"), bench.station.asked);
        assertEquals(Delivery.SENDING, shownDelivery(bench));
        bench.tap(PhoneKey.OK, PhoneKey.MESSAGE);
        assertEquals("", ((Screen.Writing) bench.snapshot().screen()).text());
    }

    private static String shownText(Bench bench) {
        return ((Screen.MessageView) bench.snapshot().screen()).message().text();
    }

    private static Delivery shownDelivery(Bench bench) {
        return ((Screen.Sent) bench.snapshot().screen()).message().delivery();
    }

    private static Bench sent() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.MESSAGE, PhoneKey.TWO, PhoneKey.OK, PhoneKey.FIVE, PhoneKey.OK);
        return bench;
    }

    @Test
    void theDisplayFollowsAMessageOnItsWay() {
        Bench bench = sent();
        assertEquals(Delivery.SENDING, shownDelivery(bench));
        bench.handset.accept(new StationEvent.MessageSent(0, new Msisdn("5"), 1));
        assertEquals(Delivery.SENT, shownDelivery(bench));
        bench.handset.accept(new StationEvent.MessageDelivered(0, new Msisdn("5")));
        assertEquals(Delivery.DELIVERED, shownDelivery(bench));
        bench.handset.accept(new StationEvent.ShortMessageReceived("5", "3 Done"));
        bench.tap(PhoneKey.OK);
        assertEquals("menu.inbox", bench.list().title().key());
    }

    @Test
    void aFailedMessageIsSentAgainFromTheOutbox() {
        Bench bench = sent();
        bench.handset.accept(new StationEvent.MessageFailed(0, new Msisdn("5"), RpCause.CONGESTION));
        assertEquals(Delivery.FAILED, shownDelivery(bench));
        assertEquals(
                Optional.of(RpCause.CONGESTION),
                bench.snapshot().in(MessageFolder.OUTBOX).get(0).cause());
        bench.tap(PhoneKey.END, PhoneKey.UP, PhoneKey.OK, PhoneKey.OK);
        assertEquals(List.of("sms 5 A", "sms 5 A"), bench.station.asked);
        assertEquals(Delivery.SENDING, shownDelivery(bench));
        assertEquals(1, bench.snapshot().in(MessageFolder.OUTBOX).size());
    }

    @Test
    void enterOpensAnswersAndSendsButNeverCallsFromAList() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        bench.tap(PhoneKey.DOWN);
        for (int i = 0; i < 2; i++) {
            enter(bench);
        }
        bench.keys().charDown('k', bench.nowNanos);
        enter(bench);
        enter(bench);
        assertEquals(List.of("sms 5550200 k"), bench.station.asked);
    }

    @Test
    void enterCallsTheNumberTypedAndTakesACall() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.FIVE);
        enter(bench);
        assertEquals(List.of("dial 5"), bench.station.asked);
        Bench other = new Bench();
        other.station.ring("5550101");
        enter(other);
        assertEquals(List.of("answer"), other.station.asked);
    }

    private static void enter(Bench bench) {
        bench.keys().enterDown(bench.nowNanos);
        bench.keys().enterUp(bench.nowNanos);
    }

    @Test
    void aBroadcastIsAnnouncedAndItsChannelCannotBeCalled() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.BroadcastReceived(50, 1, "storm"));
        assertEquals(1, bench.snapshot().unread(MessageFolder.BROADCASTS));
        bench.tap(PhoneKey.MENU, PhoneKey.ONE, PhoneKey.FIVE, PhoneKey.CALL, PhoneKey.OK, PhoneKey.CALL);
        assertEquals("storm", shownText(bench));
        assertEquals(0, bench.snapshot().unread(MessageFolder.BROADCASTS));
        assertEquals(List.of(), bench.station.asked);
    }

    @Test
    void aKeyboardWritesAnyLetter() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.MESSAGE);
        "** #*#90 **\u00e1".chars().forEach(letter -> bench.keys().charDown((char) letter, bench.nowNanos));
        assertEquals("** #*#90 **\u00e1", ((Screen.Writing) bench.snapshot().screen()).text());
    }

    @Test
    void aMessageIsReadInTheListAndAnswered() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        assertEquals(1, bench.snapshot().unread());
        bench.tap(PhoneKey.DOWN, PhoneKey.OK);
        assertEquals("3 Done", shownText(bench));
        assertEquals(0, bench.snapshot().unread());
        bench.tap(PhoneKey.OK);
        bench.keys().charDown('k', bench.nowNanos);
        bench.tap(PhoneKey.OK, PhoneKey.OK);
        assertEquals(List.of("sms 5550200 k"), bench.station.asked);
    }

    @Test
    void aMessageThatComesWhileOneIsReadDoesNotChangeWhatIsRead() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("1", "old"));
        bench.tap(PhoneKey.DOWN, PhoneKey.OK);
        bench.handset.accept(new StationEvent.ShortMessageReceived("2", "new"));
        assertEquals("old", shownText(bench));
    }

    @Test
    void theHashKeyErasesTheMessageShown() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("1", "old"));
        bench.handset.accept(new StationEvent.ShortMessageReceived("2", "new"));
        bench.tap(PhoneKey.DOWN, PhoneKey.OK, PhoneKey.HASH);
        assertEquals(
                List.of("old"),
                bench.snapshot().in(MessageFolder.INBOX).stream()
                        .map(StoredMessage::text)
                        .toList());
        assertEquals("menu.inbox", bench.list().title().key());
    }

    @Test
    void theSenderOfAMessageIsCalledWithTheGreenKey() {
        Bench bench = new Bench();
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        bench.tap(PhoneKey.DOWN, PhoneKey.CALL);
        assertEquals(List.of("sms 5550200 3 Done", "calling 5550200"), bench.events);
    }

    @Test
    void anEmptyListTakesEveryKeyWithoutHarm() {
        Bench bench = new Bench();
        for (PhoneKey key : PhoneKey.values()) {
            bench.tap(PhoneKey.END, PhoneKey.MENU, PhoneKey.ONE, PhoneKey.TWO, key);
        }
        assertEquals(List.of(), bench.snapshot().in(MessageFolder.INBOX));
    }

    @Test
    void aFullBoxForgetsItsOldest() {
        Bench bench = new Bench();
        for (int i = 0; i <= Mailbox.CAPACITY; i++) {
            bench.handset.accept(new StationEvent.ShortMessageReceived("1", "m" + i));
        }
        assertEquals(Mailbox.CAPACITY, bench.snapshot().in(MessageFolder.INBOX).size());
        assertEquals("m1", bench.snapshot().in(MessageFolder.INBOX).get(0).text());
    }

    @Test
    void aReferenceThatComesRoundMeansTheNewestMessage() {
        Bench bench = new Bench();
        for (int i = 0; i < 2; i++) {
            bench.handset.sendMessage(ROBOT, "m" + i);
            bench.handset.accept(new StationEvent.MessageSent(i, ROBOT, 1));
        }
        bench.handset.accept(new StationEvent.MessageDelivered(1, ROBOT));
        assertEquals(
                List.of(Delivery.SENT, Delivery.DELIVERED),
                bench.snapshot().in(MessageFolder.OUTBOX).stream()
                        .map(StoredMessage::delivery)
                        .toList());
    }

    @Test
    void theLateFailureOfAnErasedMessageLeavesLaterMessagesWithItsReferenceAlone() {
        Bench bench = new Bench();
        bench.handset.sendMessage(ROBOT, "erased");
        bench.tap(PhoneKey.UP, PhoneKey.OK, PhoneKey.HASH);
        assertEquals(List.of(), bench.snapshot().in(MessageFolder.OUTBOX));
        bench.handset.accept(new StationEvent.MessageFailed(0, ROBOT, RpCause.CONGESTION));
        for (int i = 1; i <= 256; i++) {
            bench.handset.sendMessage(ROBOT, "m" + i);
        }
        assertEquals(Delivery.SENDING, lastDelivery(bench));
        StationEvent.MessageSent sent = new StationEvent.MessageSent(256, ROBOT, 1);
        assertEquals(0, sent.reference());
        bench.handset.accept(sent);
        assertEquals(Delivery.SENT, lastDelivery(bench));
    }

    @Test
    void aMessageThatFailsWhileItIsSubmittedIsMarked() {
        Bench bench = new Bench();
        bench.station.failsAtOnce = true;
        bench.handset.sendMessage(ROBOT, "x");
        assertEquals(Delivery.FAILED, lastDelivery(bench));
        assertEquals(List.of("sms-failed 5550200 42"), bench.events);
    }
}
