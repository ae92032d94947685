package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RpCause;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/** The short message centre alone: a port that delivers when the test says so, and a store that is always done. */
class ShortMessageCenterTest {
    private static final Msisdn SENDER = new Msisdn("5550100");
    private static final Msisdn RECEIVER = new Msisdn("5550200");

    private final Timers timers = new Timers();
    private final Set<Msisdn> reachable = new HashSet<>();
    private final List<OctetString> delivered = new ArrayList<>();
    private final List<Consumer<DeliveryOutcome>> receipts = new ArrayList<>();
    private final List<Long> tickets = new ArrayList<>();
    private final List<MessageState> states = new ArrayList<>();
    private final List<Optional<RpCause>> answers = new ArrayList<>();

    private final DeliveryPort port = new DeliveryPort() {
        @Override
        public boolean isReachable(Destination receiver) {
            return reachable.contains(((Destination.Number) receiver).number());
        }

        @Override
        public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
            delivered.add(envelope.tpdu(moreWaiting));
            receipts.add(ended);
        }
    };

    private final ShortMessageCenter center = new ShortMessageCenter(
            new CivilTime(Instant.EPOCH, timers),
            timers,
            (ticket, entry) -> tickets.add(ticket),
            port,
            (message, state) -> states.add(state));

    private static OctetString submit(SmsAddress to, String text) {
        return TpduCodec.encode(new SubmitTpdu(false, false, false, 1, to, 0, Optional.empty(), UserData.of(text)));
    }

    private void submit(String text) {
        center.submit(SENDER, submit(SmsAddress.of(RECEIVER), text), false, answers::add);
        List<Long> done = List.copyOf(tickets);
        tickets.clear();
        done.forEach(ticket -> center.committed(ticket, true));
    }

    private String lastText() throws ProtocolViolation {
        OctetString last = delivered.get(delivered.size() - 1);
        return ((DeliverTpdu) TpduCodec.decode(last, Direction.DOWNLINK))
                .userData()
                .text();
    }

    private void end(DeliveryOutcome outcome) {
        receipts.get(receipts.size() - 1).accept(outcome);
    }

    @Test
    void tenThousandMessagesWaitForOneReceiverAndArriveInOrder() throws ProtocolViolation {
        int count = 10_000;
        for (int i = 0; i < count; i++) {
            submit("" + i);
        }
        assertEquals(count, center.waitingCount());
        assertEquals(count, center.messages().waiting().size());
        assertEquals(10, center.messages().waiting(10).size());
        reachable.add(RECEIVER);
        center.available(RECEIVER);
        for (int i = 0; i < count; i++) {
            assertEquals("" + i, lastText());
            end(DeliveryOutcome.DELIVERED);
        }
        assertEquals(count, delivered.size());
        assertEquals(0, center.waitingCount());
        assertEquals(0, timers.size(), "no expiry timer is left");
    }

    @Test
    void beyondItsLimitAReceiversQueueRefusesWithCongestion() {
        for (int i = 0; i < Admission.MAX_WAITING_PER_RECEIVER; i++) {
            submit("x");
        }
        assertTrue(answers.stream().allMatch(Optional::isEmpty));
        submit("one too many");
        assertEquals(Optional.of(RpCause.CONGESTION), answers.get(answers.size() - 1));
        center.submit(SENDER, submit(SmsAddress.of(SENDER), "to another"), false, answers::add);
        center.committed(tickets.get(0), true);
        assertEquals(Optional.empty(), answers.get(answers.size() - 1));
    }

    @Test
    void oneAttemptIsMadeAtATime() {
        reachable.add(RECEIVER);
        submit("first");
        submit("second");
        assertEquals(1, delivered.size());
        end(DeliveryOutcome.DELIVERED);
        assertEquals(2, delivered.size());
    }

    @Test
    void failuresAreRetriedAfter1Then5Then10MinutesAndTheCountStartsAgainOnSuccess() {
        reachable.add(RECEIVER);
        submit("first");
        int attempts = 1;
        long now = 0;
        for (int minutes : new int[] {1, 5, 10, 30, 60, 180, 360, 720, 720}) {
            end(DeliveryOutcome.FAILED);
            now += minutes * 60_000_000_000L;
            timers.advance(now - 1);
            assertEquals(attempts, delivered.size(), minutes + " minutes");
            timers.advance(now);
            assertEquals(++attempts, delivered.size(), minutes + " minutes");
        }
        end(DeliveryOutcome.DELIVERED);
        submit("second");
        end(DeliveryOutcome.FAILED);
        timers.advance(now + 60_000_000_000L);
        assertEquals(attempts + 2, delivered.size());
    }

    @Test
    void appearingCutsTheWaitShort() {
        reachable.add(RECEIVER);
        submit("first");
        end(DeliveryOutcome.ABSENT);
        center.available(RECEIVER);
        assertEquals(2, delivered.size());
    }

    @Test
    void aMessageThatExpiresUnderWayIsDeliveredIfItArrives() {
        reachable.add(RECEIVER);
        submit("first");
        timers.advance(8L * 24 * 3600 * 1_000_000_000L);
        assertEquals(List.of(MessageState.ACCEPTED), states);
        end(DeliveryOutcome.DELIVERED);
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.DELIVERED), states);
    }

    @Test
    void aMessageThatExpiresUnderWayIsNotTriedAgain() {
        reachable.add(RECEIVER);
        submit("first");
        timers.advance(8L * 24 * 3600 * 1_000_000_000L);
        end(DeliveryOutcome.FAILED);
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.EXPIRED), states);
        assertEquals(0, timers.size());
    }

    private static OctetString repeated(int reference, String text) {
        return TpduCodec.encode(new SubmitTpdu(
                true, false, false, reference, SmsAddress.of(RECEIVER), 0, Optional.empty(), UserData.of(text)));
    }

    @Test
    void aRepetitionOfAStoredMessageIsAcknowledgedAndNotStoredAgain() {
        submit("** #**20 **");
        center.submit(SENDER, repeated(1, "** #**20 **"), false, answers::add);
        assertEquals(List.of(Optional.empty(), Optional.empty()), answers);
        assertTrue(tickets.isEmpty());
        assertEquals(1, center.waitingCount());
    }

    @Test
    void aRepetitionIsKnownEvenAfterTheMessageWasDelivered() {
        reachable.add(RECEIVER);
        submit("** #**20 **");
        end(DeliveryOutcome.DELIVERED);
        center.submit(SENDER, repeated(1, "** #**20 **"), false, answers::add);
        assertEquals(1, delivered.size(), "a robot must not drive an order twice");
    }

    @Test
    void aRepetitionOfAMessageStillBeingStoredWaitsForTheStore() {
        center.submit(SENDER, submit(SmsAddress.of(RECEIVER), "hello"), false, answers::add);
        center.submit(SENDER, repeated(1, "hello"), false, answers::add);
        assertEquals(1, tickets.size());
        assertTrue(answers.isEmpty());
        center.committed(tickets.get(0), true);
        assertEquals(List.of(Optional.empty(), Optional.empty()), answers);
    }

    @Test
    void aRepetitionOfAMessageThatWasNotStoredIsStored() {
        center.submit(SENDER, submit(SmsAddress.of(RECEIVER), "hello"), false, answers::add);
        center.committed(tickets.remove(0), false);
        center.submit(SENDER, repeated(1, "hello"), false, answers::add);
        assertEquals(1, tickets.size());
    }

    @Test
    void whatOnlyLooksLikeARepetitionIsStored() {
        submit("hello");
        submit("hello");
        center.submit(SENDER, repeated(2, "hello"), false, answers::add);
        center.submit(SENDER, repeated(1, "hullo"), false, answers::add);
        center.submit(RECEIVER, repeated(1, "hello"), false, answers::add);
        assertEquals(3, tickets.size(), "another reference, another text, another sender");
        timers.advance(RecentSubmissions.REMEMBERED_NANOS + 1);
        center.submit(SENDER, repeated(1, "hello"), false, answers::add);
        assertEquals(4, tickets.size(), "too long ago");
    }

    @Test
    void aReferenceThatHasComeRoundIsNoRepetition() {
        submit("hello");
        for (int i = 0; i < RecentSubmissions.MOST_SINCE; i++) {
            submit("other");
        }
        center.submit(SENDER, repeated(1, "hello"), false, answers::add);
        assertTrue(tickets.isEmpty(), "a repetition, if barely");
        submit("one more");
        center.submit(SENDER, repeated(1, "hello"), false, answers::add);
        assertEquals(1, tickets.size());
    }

    @Test
    void twoTextsAlikeInOneSecondDifferInTheirTimeStampThoughTheCentreStartedAgainBetweenThem()
            throws ProtocolViolation {
        reachable.add(RECEIVER);
        submit("hello");
        ShortMessage first = center.messages().waiting().get(0);
        ShortMessageCenter again = new ShortMessageCenter(
                new CivilTime(Instant.EPOCH, timers),
                timers,
                (ticket, entry) -> tickets.add(ticket),
                port,
                (message, state) -> {});
        again.restore(new StoredState(1, List.of(), List.of(), List.of(first), List.of()));
        again.submit(SENDER, submit(SmsAddress.of(RECEIVER), "hello"), false, answers::add);
        again.committed(tickets.get(0), true);
        assertEquals(2, Set.copyOf(delivered).size(), "the receiver can tell them apart");
    }

    @Test
    void aMessageToLettersIsRefusedWithCause1() {
        center.submit(SENDER, submit(SmsAddress.ofLetters("Nobody"), "hello"), false, answers::add);
        assertEquals(List.of(Optional.of(RpCause.UNASSIGNED_NUMBER)), answers);
        assertTrue(tickets.isEmpty());
    }

    @Test
    void aMessageKnowsItsWords() {
        submit("** #**20 **");
        ShortMessage waiting = center.messages().waiting().get(0);
        assertEquals("** #**20 **", waiting.text());
        assertEquals(1, waiting.id());
        assertFalse(waiting.expiresAt().isBefore(Instant.EPOCH.plusSeconds(3600)));
    }
}
