package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/**
 * Every command with as many messages as the centre holds. The work is counted in steps on the collections that grow with
 * the messages, so that one client's command cannot stop the exchange for the others.
 */
class LargestSizeTest {
    /** Steps that a command may cost, however many messages wait. */
    private static final long FEW = 20;

    private static final Msisdn SENDER = new Msisdn("5550100");
    private static final int RECEIVERS = 500_000;

    private static final Msisdn RECEIVER = new Msisdn("5550200");
    private static final OctetString SUBMIT =
            TpduCodec.encode(SubmitTpdu.of(1, SmsAddress.of(RECEIVER), UserData.of("x")));
    private static final Destination QUEUE = new Destination.Number(RECEIVER);

    private final CountingContainers containers = new CountingContainers();
    private final Timers timers = new Timers();
    private final Deque<Long> tickets = new ArrayDeque<>();
    private final Deque<Consumer<DeliveryOutcome>> underWay = new ArrayDeque<>();
    private final Set<Destination> asked = new HashSet<>();
    private boolean isThere;
    private int window = 1;
    private Optional<RpCause> answer = Optional.empty();

    private final DeliveryPort port = new DeliveryPort() {
        @Override
        public boolean isReachable(Destination destination) {
            asked.add(destination);
            return isThere;
        }

        @Override
        public int window(Destination destination) {
            return window;
        }

        @Override
        public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
            underWay.add(ended);
        }
    };

    private final ShortMessageCenter center = new ShortMessageCenter(
            new CivilTime(Instant.EPOCH, timers),
            timers,
            (ticket, entries) -> tickets.add(ticket),
            port,
            (message, state) -> {},
            containers,
            new HeldOctets((long) RECEIVERS * (HeldOctets.ENVELOPE + SUBMIT.length())));

    /** Submits and stores; returns the message's id. */
    private long submit(Msisdn to, Optional<ValidityPeriod> validity) {
        long id = center.nextId();
        OctetString submit = TpduCodec.encode(
                new SubmitTpdu(false, false, false, 1, SmsAddress.of(to), 0, validity, UserData.of("x")));
        center.submit(SENDER, submit, false, refusal -> answer = refusal);
        store();
        return id;
    }

    private long submit(Msisdn to) {
        return submit(to, Optional.empty());
    }

    private void store() {
        while (!tickets.isEmpty()) {
            center.committed(tickets.remove(), true);
        }
    }

    /** Messages that wait from the start, with ids from 1 on. */
    private void fill(int count, IntFunction<Msisdn> receiver) {
        Instant aWeekLater = Instant.EPOCH.plus(Duration.ofDays(7));
        List<ShortMessage> messages = IntStream.rangeClosed(1, count)
                .mapToObj(id -> new ShortMessage(id, SENDER, receiver.apply(id), SUBMIT, Instant.EPOCH, aWeekLater))
                .toList();
        center.restore(new StoredState(count, messages, List.of(), List.of(), List.of()));
    }

    private void fillTheReceiver() {
        fill(Admission.MAX_WAITING_PER_RECEIVER, id -> RECEIVER);
    }

    private void assertFew(String command, Runnable action) {
        long steps = containers.stepsOf(action);
        assertTrue(steps <= FEW, command + ": " + steps + " steps");
    }

    @Test
    void noCommandOnAFullQueueCostsMoreTheMoreMessagesWait() {
        fillTheReceiver();
        int count = Admission.MAX_WAITING_PER_RECEIVER;
        for (long id : new long[] {1, count / 2, count}) {
            assertFew(
                    "history of " + id,
                    () -> assertTrue(center.messages().history(id).isPresent()));
            assertFew(
                    "state of " + id,
                    () -> assertTrue(center.messages().waitingMessage(id).isPresent()));
            assertFew("cancel of " + id, () -> assertTrue(center.cancel(id)));
            assertFew("second cancel of " + id, () -> assertFalse(center.cancel(id)));
            assertFew(
                    "history of " + id + ", ended",
                    () -> assertTrue(center.messages().history(id).isPresent()));
        }
        assertFew(
                "history of an unknown message",
                () -> assertTrue(center.messages().history(count + 1).isEmpty()));
        center.cancel(2);
        assertFew("submission", () -> submit(RECEIVER));
        assertFew("an absent receiver's room", () -> center.roomFor(QUEUE));
        isThere = true;
        assertFew("the receiver's registration", () -> center.available(RECEIVER));
        assertFew("delivery", () -> underWay.remove().accept(DeliveryOutcome.DELIVERED));
        assertFew("failure", () -> underWay.remove().accept(DeliveryOutcome.FAILED));
        assertFew(
                "retry",
                () -> timers.advance(
                        timers.nowNanos() + RetrySchedule.PAUSES.get(0).toNanos()));
        assertEquals(1, underWay.size());
    }

    @Test
    void failuresOfSingleMessagesCostNoMoreTheMoreOfThemWait() {
        fillTheReceiver();
        isThere = true;
        window = 1_000;
        center.available(RECEIVER);
        for (int i = 0; i < 1_000; i++) {
            assertFew("postponing", () -> underWay.remove().accept(DeliveryOutcome.POSTPONED));
        }
        assertFew("withdrawal", () -> underWay.remove().accept(DeliveryOutcome.WITHDRAWN));
        assertFew("cancel of a postponed one", () -> assertTrue(center.cancel(1)));
        isThere = false;
        assertFew("the receiver becomes available", () -> center.available(RECEIVER));
        assertEquals(Admission.MAX_WAITING_PER_RECEIVER - 1, center.waitingCount());
    }

    @Test
    void replacingCostsNoMoreTheMoreMessagesWait() {
        fillTheReceiver();
        for (long id : new long[] {1, 100_000, Admission.MAX_WAITING_PER_RECEIVER}) {
            ShortMessage old = center.messages().waitingMessage(id).orElseThrow();
            assertFew("replacement of " + id, () -> {
                assertTrue(center.replace(old, stored -> {}));
                store();
            });
        }
        assertEquals(Admission.MAX_WAITING_PER_RECEIVER, center.waitingCount());
    }

    @Test
    void aListCostsWhatItShows() {
        fillTheReceiver();
        long steps = containers.stepsOf(() ->
                assertEquals(1_000, center.messages().waitingHistories(1_000).size()));
        assertTrue(steps <= 2_000 + FEW, steps + " steps");
        assertEquals(
                1_000,
                containers.stepsOf(() ->
                        assertEquals(1_000, center.messages().waiting(1_000).size())));
    }

    @Test
    void whatHasExpiredBehindAMessageThatWaitsIsNoLongerHeld() {
        submit(RECEIVER);
        long held = containers.held();
        Optional<ValidityPeriod> fiveMinutes = Optional.of(new ValidityPeriod.Relative(0));
        for (int i = 0; i < 20; i++) {
            for (int j = 0; j < 1_000; j++) {
                submit(RECEIVER, fiveMinutes);
            }
            timers.advance(timers.nowNanos() + Duration.ofMinutes(5).toNanos());
            store();
        }
        assertEquals(1, center.waitingCount());
        assertEquals(held, containers.held());
    }

    @Test
    void whatWasCancelledBehindAMessageThatWaitsIsNoLongerHeld() {
        submit(RECEIVER);
        long held = containers.held();
        for (int i = 0; i < 5_000; i++) {
            assertTrue(center.cancel(submit(RECEIVER)));
        }
        assertEquals(1, center.waitingCount());
        assertEquals(held, containers.held());
    }

    @Test
    void theLimitCountsTheMessagesThatAreBeingStored() {
        fill(Admission.MAX_WAITING_PER_RECEIVER - 1, id -> RECEIVER);
        OctetString submit = TpduCodec.encode(SubmitTpdu.of(1, SmsAddress.of(RECEIVER), UserData.of("two more")));
        center.submit(SENDER, submit, false, refusal -> answer = refusal);
        center.submit(SENDER, submit, false, refusal -> answer = refusal);
        assertEquals(Optional.of(RpCause.CONGESTION), answer, "one place is left, and taken");
        center.committed(tickets.remove(), false);
        assertEquals(Optional.of(RpCause.NETWORK_OUT_OF_ORDER), answer);
        submit(RECEIVER);
        assertEquals(Optional.empty(), answer, "the place is free again");
    }

    @Test
    void halfAMillionReceiversBecomeAvailableAThousandAtATime() {
        fill(RECEIVERS, id -> new Msisdn(Integer.toString(5_600_000 + id)));
        submit(RECEIVER);
        assertEquals(Optional.of(RpCause.CONGESTION), answer, "half a million wait");
        assertFew("history", () -> center.messages().history(250_000));
        asked.clear();
        long most = 4L * ReceiverQueues.SCANNED_AT_ONCE;
        assertTrue(containers.stepsOf(() -> center.available(each -> true)) <= most);
        assertTrue(containers.stepsOf(() -> center.available(each -> false)) <= FEW, "one scan at a time");
        for (int i = 0; i < RECEIVERS / ReceiverQueues.SCANNED_AT_ONCE; i++) {
            assertTrue(containers.stepsOf(() -> timers.advance(timers.nowNanos() + 1_000_000)) <= most);
        }
        assertEquals(RECEIVERS, asked.size(), "all were asked for");
    }
}
