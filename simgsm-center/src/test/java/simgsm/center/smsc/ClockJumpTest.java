package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/** A pair of clocks moved by hand: the wall clock is set, or goes on while the monotonic clock sleeps. */
class ClockJumpTest {
    private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
    private static final Msisdn RECEIVER = new Msisdn("5550200");
    private static final Duration HOUR = Duration.ofHours(1);

    private final Timers timers = new Timers();
    private final CivilTime civil = new CivilTime(NOON, timers);
    private final List<MessageState> states = new ArrayList<>();
    private final List<ShortMessage> accepted = new ArrayList<>();
    private final List<Envelope> attempts = new ArrayList<>();
    private boolean isReachable;

    private final DeliveryPort port = new DeliveryPort() {
        @Override
        public boolean isReachable(Destination destination) {
            return isReachable;
        }

        @Override
        public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
            attempts.add(envelope);
        }
    };

    private final List<Long> tickets = new ArrayList<>();
    private final ShortMessageCenter center =
            new ShortMessageCenter(civil, timers, (ticket, entries) -> tickets.add(ticket), port, (message, state) -> {
                states.add(state);
                if (state == MessageState.ACCEPTED) {
                    accepted.add(message);
                }
            });

    private void submit(Optional<Instant> deliverAt, Instant expiresAt) {
        EsmeOrigin origin = new EsmeOrigin("shop", SmsAddress.ofLetters("Shop"), 0, EsmeOrigin.Receipts.NONE)
                .with(EsmeOrigin.Receipts.NONE, deliverAt);
        SubmitTpdu unit = new SubmitTpdu(
                false, false, false, 1, SmsAddress.of(RECEIVER), 0, Optional.empty(), UserData.of("hello"));
        center.submit(origin, new Msisdn("1"), List.of(unit), Optional.of(expiresAt), refusal -> {});
        tickets.forEach(ticket -> center.committed(ticket, true));
        tickets.clear();
    }

    private void passes(Duration time) {
        timers.advance(timers.nowNanos() + time.toNanos());
    }

    /** As the exchange does. */
    private void wallClockShows(Instant wall) {
        if (civil.isJump(wall)) {
            center.timeHasJumped();
            passes(Duration.ZERO);
        }
    }

    @Test
    void aMessageWhoseValidityEndsWhileTheMachineSleepsHasExpiredWhenItWakes() {
        submit(Optional.empty(), NOON.plus(HOUR));
        wallClockShows(NOON.plus(HOUR.multipliedBy(2)));

        assertEquals(List.of(MessageState.ACCEPTED, MessageState.EXPIRED), states);
    }

    @Test
    void aMessageLivesItsValidityByTheClockThatWasSetBack() {
        submit(Optional.empty(), NOON.plus(HOUR));
        wallClockShows(NOON.minus(HOUR));
        passes(HOUR.multipliedBy(2).minusSeconds(1));
        assertEquals(List.of(MessageState.ACCEPTED), states);

        passes(Duration.ofSeconds(1));
        assertEquals(List.of(MessageState.ACCEPTED, MessageState.EXPIRED), states);
    }

    @Test
    void aScheduledMessageIsTriedWhenTheClockIsSetPastItsTime() {
        isReachable = true;
        submit(Optional.of(NOON.plus(HOUR)), NOON.plus(HOUR.multipliedBy(9)));
        assertTrue(attempts.isEmpty());

        wallClockShows(NOON.plus(HOUR));

        assertEquals(1, attempts.size());
    }

    @Test
    void aMessageIsStampedByTheClockThatWasSetBackAndAnEqualOneLater() {
        submit(Optional.empty(), NOON.plus(HOUR));
        Instant back = NOON.minus(HOUR.multipliedBy(3));
        wallClockShows(back);
        submit(Optional.empty(), NOON.plus(HOUR));
        submit(Optional.empty(), NOON.plus(HOUR));

        assertEquals(
                List.of(NOON, back, back.plusSeconds(1)),
                accepted.stream().map(ShortMessage::acceptedAt).toList());
    }

    @Test
    void aClockThatIsSlowlyCorrectedMovesStampsAndNoTimers() {
        assertFalse(civil.isJump(NOON.plusMillis(900)));
        assertEquals(NOON.plusMillis(900), civil.now());
        assertTrue(civil.isJump(NOON.plusMillis(1_000)));
        assertFalse(civil.isJump(NOON.plusMillis(1_999)));
    }

    @Test
    void theRetryScheduleCountsTheTimeThatHasPassed() {
        isReachable = true;
        submit(Optional.empty(), NOON.plus(HOUR.multipliedBy(9)));
        int before = timers.size();
        wallClockShows(NOON.plus(HOUR));

        assertEquals(before, timers.size());
        assertEquals(1, attempts.size());
    }
}
