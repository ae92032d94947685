package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/** What the centre stores, what it does with a restored store, and what it sends back as reports. */
class StoredMessagesTest {
    private static final Instant START = Instant.parse("2026-11-21T12:00:00Z");
    private static final Msisdn SENDER = new Msisdn("5550100");
    private static final Msisdn RECEIVER = new Msisdn("5550200");
    private static final Destination SHOP = new Destination.Esme("shop");

    private final Timers timers = new Timers();
    private final Deque<Long> tickets = new ArrayDeque<>();
    private final List<StoreEntry> stored = new ArrayList<>();
    private final List<Envelope> delivered = new ArrayList<>();
    private final List<Boolean> moreWaiting = new ArrayList<>();
    private final Deque<Consumer<DeliveryOutcome>> underWay = new ArrayDeque<>();
    private final List<Destination> emptied = new ArrayList<>();
    private final List<MessageState> states = new ArrayList<>();
    private final List<Optional<RpCause>> answers = new ArrayList<>();
    private boolean isThere = true;
    private boolean isServed = true;

    private final DeliveryPort port = new DeliveryPort() {
        @Override
        public boolean isServed(Msisdn number) {
            return isServed;
        }

        @Override
        public boolean isReachable(Destination destination) {
            return isThere;
        }

        @Override
        public void deliver(Envelope envelope, boolean more, Consumer<DeliveryOutcome> ended) {
            delivered.add(envelope);
            moreWaiting.add(more);
            underWay.add(ended);
        }

        @Override
        public void emptied(Destination destination) {
            emptied.add(destination);
        }
    };

    private final ShortMessageCenter center = new ShortMessageCenter(
            new CivilTime(START, timers),
            timers,
            (ticket, entries) -> {
                stored.addAll(entries);
                tickets.add(ticket);
            },
            port,
            (message, state) -> states.add(state));

    private static SubmitTpdu unit(String text, boolean wantsReport) {
        return new SubmitTpdu(
                false, wantsReport, false, 7, SmsAddress.of(RECEIVER), 0, Optional.empty(), UserData.of(text));
    }

    private static ShortMessage message(long id, boolean wantsReport, Optional<EsmeOrigin> origin) {
        OctetString submit = TpduCodec.encode(unit("m" + id, wantsReport));
        return new ShortMessage(id, SENDER, RECEIVER, submit, START, START.plus(Duration.ofDays(7)), origin);
    }

    private static EsmeOrigin shop(EsmeOrigin.Receipts receipts) {
        return new EsmeOrigin("shop", SmsAddress.ofLetters("Shop"), 0, receipts);
    }

    private static StoredState stored(List<ShortMessage> waiting, List<StoredState.Unreported> unreported) {
        return new StoredState(10, waiting, unreported, List.of(), List.of());
    }

    private void submit(String text, boolean wantsReport) {
        center.submit(SENDER, TpduCodec.encode(unit(text, wantsReport)), false, answers::add);
    }

    private void submit(EsmeOrigin origin, int parts) {
        List<SubmitTpdu> units = IntStream.range(0, parts)
                .mapToObj(i -> unit("part " + i, false))
                .toList();
        center.submit(origin, SENDER, units, Optional.empty(), answers::add);
    }

    private void store(boolean isDurable) {
        List<Long> done = List.copyOf(tickets);
        tickets.clear();
        done.forEach(ticket -> center.committed(ticket, isDurable));
    }

    private void passSeconds(long seconds) {
        timers.advance(timers.nowNanos() + Duration.ofSeconds(seconds).toNanos());
    }

    private void end(DeliveryOutcome outcome) {
        underWay.remove().accept(outcome);
    }

    @Test
    void restoredMessagesAreDeliveredAndTheNextIdFollowsTheLastOne() {
        center.restore(
                stored(List.of(message(3, false, Optional.empty()), message(4, false, Optional.empty())), List.of()));
        assertEquals(11, center.nextId());
        assertEquals(2, center.waitingCount());
        assertEquals(
                List.of(3L, 4L),
                center.messages().waiting().stream().map(ShortMessage::id).toList());
        assertEquals(3, delivered.get(0).message().id());
        end(DeliveryOutcome.DELIVERED);
        end(DeliveryOutcome.DELIVERED);
        assertEquals(0, center.waitingCount());
        assertEquals(List.of(false, false), moreWaiting, "the second message was restored after the first attempt");
        assertEquals(List.of(new Destination.Number(RECEIVER)), emptied);
    }

    @Test
    void aRestoredEndIsReportedToItsSender() {
        ShortMessage ended = message(3, true, Optional.empty());
        StoreEntry.Ended end = new StoreEntry.Ended(3, MessageState.EXPIRED, START.minusSeconds(60), true);
        center.restore(stored(List.of(), List.of(new StoredState.Unreported(ended, end))));
        Envelope.Report report = (Envelope.Report) delivered.get(0);
        assertEquals(MessageState.EXPIRED, report.state());
        assertEquals(START.minusSeconds(60), report.at());
        assertEquals(START.minusSeconds(60).plus(Duration.ofDays(7)), report.expiresAt());
        assertEquals(new Destination.Number(SENDER), report.destination());
        end(DeliveryOutcome.DELIVERED);
        assertEquals(List.of(new StoreEntry.Reported(3)), stored);
        assertEquals(List.of(), states, "the end of a report is no change of a message");
    }

    @Test
    void aSubmissionBeforeTheRestartIsRecognisedForAnHour() {
        ShortMessage earlier = new ShortMessage(
                3,
                SENDER,
                RECEIVER,
                TpduCodec.encode(unit("hello", false)),
                START.minus(Duration.ofMinutes(50)),
                START,
                Optional.empty());
        center.restore(new StoredState(3, List.of(), List.of(), List.of(earlier), List.of()));
        OctetString again = TpduCodec.encode(unit("hello", false));
        center.submit(SENDER, again, true, answers::add);
        assertEquals(List.of(Optional.empty()), answers);
        assertTrue(tickets.isEmpty());
        passSeconds(Duration.ofMinutes(10).toSeconds() + 1);
        center.submit(SENDER, again, true, answers::add);
        assertEquals(1, tickets.size(), "more than an hour ago");
    }

    @Test
    void aMessageOfAnApplicationBeforeTheRestartIsNoSubmissionOfItsNumber() {
        ShortMessage earlier = message(3, false, Optional.of(shop(EsmeOrigin.Receipts.NONE)));
        center.restore(new StoredState(3, List.of(), List.of(), List.of(earlier), List.of()));
        center.submit(SENDER, TpduCodec.encode(unit("m3", false)), true, answers::add);
        assertEquals(1, tickets.size());
    }

    @Test
    void anEndWithAReportIsStoredBeforeTheReportIsSent() {
        submit("hello", true);
        store(true);
        end(DeliveryOutcome.DELIVERED);
        assertEquals(new StoreEntry.Ended(1, MessageState.DELIVERED, START, true), stored.get(1));
        assertEquals(1, delivered.size());
        store(true);
        assertInstanceOf(Envelope.Report.class, delivered.get(1));
        assertEquals(1, center.waitingCount());
    }

    @Test
    void anEndThatIsNotStoredIsStoredAgainUnchangedAfter5Seconds() {
        submit("hello", true);
        store(true);
        end(DeliveryOutcome.REFUSED);
        store(false);
        passSeconds(4);
        assertEquals(2, stored.size());
        passSeconds(1);
        assertEquals(stored.get(1), stored.get(2));
        store(true);
        assertEquals(MessageState.REJECTED, ((Envelope.Report) delivered.get(1)).state());
    }

    @Test
    void anEndWithoutAReportIsStoredOnce() {
        submit("hello", false);
        store(true);
        end(DeliveryOutcome.DELIVERED);
        assertEquals(new StoreEntry.Ended(1, MessageState.DELIVERED, START, false), stored.get(1));
        assertEquals(List.of(MessageStore.NO_TICKET), List.copyOf(tickets));
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.DELIVERED), states);
    }

    @ParameterizedTest
    @EnumSource(EsmeOrigin.Receipts.class)
    void anApplicationGetsTheReceiptsThatItHasAskedFor(EsmeOrigin.Receipts receipts) {
        submit(shop(receipts), 1);
        store(true);
        end(DeliveryOutcome.DELIVERED);
        submit(shop(receipts), 1);
        store(true);
        underWay.removeLast().accept(DeliveryOutcome.REFUSED);
        List<Boolean> reported = stored.stream()
                .filter(StoreEntry.Ended.class::isInstance)
                .map(entry -> ((StoreEntry.Ended) entry).reportFollows())
                .toList();
        assertEquals(List.of(receipts == EsmeOrigin.Receipts.ALWAYS, receipts != EsmeOrigin.Receipts.NONE), reported);
    }

    @Test
    void aMessageInPartsHasConsecutiveIdsAndOneReceipt() {
        isThere = false;
        submit(shop(EsmeOrigin.Receipts.ALWAYS), 3);
        assertEquals(4, center.nextId());
        assertEquals(1, tickets.size());
        assertEquals(List.of(), answers);
        store(true);
        assertEquals(List.of(Optional.empty()), answers);
        assertEquals(
                List.of(EsmeOrigin.Receipts.NONE, EsmeOrigin.Receipts.NONE, EsmeOrigin.Receipts.ALWAYS),
                center.messages().waiting().stream()
                        .map(part -> part.esme().orElseThrow().receipts())
                        .toList());
        assertEquals(
                List.of(1L, 2L, 3L),
                center.messages().waiting().stream().map(ShortMessage::id).toList());
        assertEquals(
                START.plus(Duration.ofDays(7)),
                center.messages().waiting().get(0).expiresAt());
    }

    @Test
    void whatTheStoreRefusesIsRejectedInFullAndItsPlacesAreFree() {
        submit(shop(EsmeOrigin.Receipts.ALWAYS), 3);
        store(false);
        assertEquals(List.of(Optional.of(RpCause.NETWORK_OUT_OF_ORDER)), answers);
        assertEquals(List.of(MessageState.REJECTED, MessageState.REJECTED, MessageState.REJECTED), states);
        assertEquals(0, center.waitingCount());
        assertEquals(List.of(new Destination.Number(RECEIVER)), emptied);
    }

    @Test
    void upTo50000MessagesAreBeingStored() {
        for (int i = 0; i < Admission.MAX_UNCOMMITTED - 2; i++) {
            submit("x", false);
        }
        submit(shop(EsmeOrigin.Receipts.NONE), 3);
        assertEquals(List.of(Optional.of(RpCause.CONGESTION)), answers);
        submit(shop(EsmeOrigin.Receipts.NONE), 2);
        assertEquals(1, answers.size());
        submit("one too many", false);
        assertEquals(2, answers.size());
        center.committed(tickets.remove(), false);
        submit("in its place", false);
        assertEquals(3, answers.size(), "the refusal of the first one, and no other");
    }

    @Test
    void aNumberThatIsNotServedIsUnassigned() {
        isServed = false;
        submit("hello", false);
        submit(shop(EsmeOrigin.Receipts.NONE), 1);
        assertEquals(List.of(Optional.of(RpCause.UNASSIGNED_NUMBER), Optional.of(RpCause.UNASSIGNED_NUMBER)), answers);
        assertEquals(1, center.nextId());
    }

    @Test
    void aMessageThatIsBeingDeliveredCannotBeCancelled() {
        submit("hello", false);
        store(true);
        assertFalse(center.cancel(1));
        end(DeliveryOutcome.FAILED);
        assertTrue(center.cancel(1));
        assertFalse(center.cancel(1));
        assertEquals(
                MessageState.DELETED, center.messages().history(1).orElseThrow().state());
        assertEquals(
                Optional.of(START), center.messages().history(1).orElseThrow().endedAt());
        assertEquals(0, timers.size());
        assertFalse(center.cancel(2), "there is none");
    }

    @Test
    void anExpiryOrCancellationDoesNotRestartTheRetrySchedule() {
        for (int i = 0; i < 3; i++) {
            submit("m" + i, false);
        }
        store(true);
        end(DeliveryOutcome.FAILED);
        passSeconds(60);
        end(DeliveryOutcome.FAILED);
        assertTrue(center.cancel(1));
        passSeconds(299);
        assertEquals(2, delivered.size());
        passSeconds(1);
        end(DeliveryOutcome.FAILED);
        passSeconds(599);
        assertEquals(3, delivered.size());
        passSeconds(1);
        assertEquals(4, delivered.size(), "10 minutes after the third failure in a row");
    }

    @Test
    void aMessageThatExpiresUnderWayAndFailsStillPausesTheOthers() {
        submit("first", false);
        submit("second", false);
        store(true);
        timers.advance(Duration.ofDays(6).toNanos());
        submit("third", false);
        store(true);
        timers.advance(Duration.ofDays(7).toNanos());
        assertEquals(2, center.waitingCount(), "the second has expired, the first is under way");
        end(DeliveryOutcome.MEMORY_FULL);
        assertEquals(1, delivered.size());
        assertEquals(
                WaitReason.AWAITING_MEMORY,
                center.messages().waitingHistories(1).get(0).waitReason());
        passSeconds(60);
        assertEquals(2, delivered.size());
        end(DeliveryOutcome.DELIVERED);
        assertEquals(0, timers.size());
    }

    @Test
    void roomForADestinationLetsOnlyThatOneGoOn() {
        isThere = false;
        submit("hello", false);
        store(true);
        isThere = true;
        center.roomFor(SHOP);
        assertEquals(0, delivered.size());
        center.roomFor(new Destination.Number(RECEIVER));
        assertEquals(1, delivered.size());
    }

    @Test
    void aScanMakesOnlyTheChosenDestinationsAvailable() {
        isThere = false;
        submit("hello", false);
        store(true);
        isThere = true;
        center.available(each -> each instanceof Destination.Esme);
        assertEquals(0, delivered.size());
        center.available(each -> each instanceof Destination.Number);
        assertEquals(1, delivered.size());
        assertEquals(1, timers.size(), "the expiry, and no further scan");
    }

    @Test
    void receiptsThatAnApplicationDoesNotFetchAreLimited() {
        isThere = false;
        Optional<EsmeOrigin> origin = Optional.of(shop(EsmeOrigin.Receipts.ALWAYS));
        List<StoredState.Unreported> unreported = IntStream.rangeClosed(1, ShortMessageCenter.MAX_WAITING_RECEIPTS + 1)
                .mapToObj(id -> new StoredState.Unreported(
                        message(id, false, origin), new StoreEntry.Ended(id, MessageState.DELIVERED, START, true)))
                .toList();
        center.restore(stored(List.of(), unreported));
        assertEquals(ShortMessageCenter.MAX_WAITING_RECEIPTS, center.waitingCount());
        assertEquals(List.of(new StoreEntry.Reported(ShortMessageCenter.MAX_WAITING_RECEIPTS + 1)), stored);
        assertEquals(List.of(), center.messages().waiting(), "reports are not listed");
    }

    @Test
    void aFurtherListenerHearsOfEveryChange() {
        List<MessageState> heard = new ArrayList<>();
        center.addListener((message, state) -> heard.add(state));
        submit("hello", false);
        store(true);
        end(DeliveryOutcome.DELIVERED);
        assertEquals(states, heard);
        assertEquals(2, heard.size());
    }

    @Test
    void numbersComeBeforeApplicationsAndEachKindIsOrderedByText() {
        List<Destination> ordered = List.of(
                new Destination.Number(new Msisdn("100")),
                new Destination.Number(new Msisdn("9")),
                new Destination.Esme("1"),
                SHOP);
        assertEquals(
                ordered,
                List.of(SHOP, ordered.get(1), ordered.get(2), ordered.get(0)).stream()
                        .sorted()
                        .toList());
        assertEquals("shop", SHOP.toString());
    }
}
