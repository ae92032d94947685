package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;
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

/** The limit by the heap: what counts, and that it counts no longer once it has left. */
class HeldOctetsTest {
    private static final Msisdn SENDER = new Msisdn("5550100");
    private static final Msisdn RECEIVER = new Msisdn("5550200");
    private static final int MOST = 20_000;

    private final Timers timers = new Timers();
    private final HeldOctets held = new HeldOctets(MOST);
    private final Deque<Long> tickets = new ArrayDeque<>();
    private final Deque<Consumer<DeliveryOutcome>> underWay = new ArrayDeque<>();
    private boolean isThere;
    private int references;
    private Optional<RpCause> answer;

    private final DeliveryPort port = new DeliveryPort() {
        @Override
        public boolean isServed(Msisdn number) {
            return true;
        }

        @Override
        public boolean isReachable(Destination destination) {
            return isThere;
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
            ReceiverQueues.Containers.STANDARD,
            held);

    private boolean submit() {
        SubmitTpdu unit = new SubmitTpdu(
                false,
                true,
                false,
                references++ % 256,
                SmsAddress.of(RECEIVER),
                0,
                Optional.of(new ValidityPeriod.Relative(0)),
                UserData.of("x"));
        OctetString submit = TpduCodec.encode(unit);
        answer = Optional.empty();
        center.submit(SENDER, submit, false, refusal -> answer = refusal);
        return answer.isEmpty();
    }

    private int submitUntilRefused() {
        int accepted = 0;
        while (submit()) {
            accepted++;
        }
        assertEquals(Optional.of(RpCause.CONGESTION), answer);
        return accepted;
    }

    private void store(boolean isDurable) {
        while (!tickets.isEmpty()) {
            center.committed(tickets.remove(), isDurable);
        }
    }

    @Test
    void messagesThatAreBeingStoredCountAndAreFreeAgainIfTheStoreFails() {
        int accepted = submitUntilRefused();
        assertTrue(accepted > 10 && accepted * (long) HeldOctets.ENVELOPE <= MOST, accepted + " accepted");
        store(false);
        assertEquals(0, held.held());
        assertEquals(accepted, submitUntilRefused());
    }

    @Test
    void messagesAndReportsCountUntilTheyHaveLeft() {
        int accepted = submitUntilRefused();
        store(true);
        assertEquals(Optional.of(RpCause.CONGESTION), refusalNow());
        isThere = true;
        center.available(RECEIVER);
        for (int i = 0; i < accepted; i++) {
            underWay.remove().accept(DeliveryOutcome.DELIVERED);
        }
        store(true);
        assertTrue(held.held() > 0, "the reports wait");
        center.available(SENDER);
        while (!underWay.isEmpty()) {
            underWay.remove().accept(DeliveryOutcome.DELIVERED);
        }
        store(true);
        assertEquals(0, held.held());
    }

    private Optional<RpCause> refusalNow() {
        submit();
        return answer;
    }

    @Test
    void failedAttemptsCountAsLongAsTheyAreRemembered() {
        assertTrue(submit());
        store(true);
        long untried = held.held();
        isThere = true;
        center.available(RECEIVER);
        isThere = false;
        underWay.remove().accept(DeliveryOutcome.FAILED);
        assertTrue(held.held() > untried);
        assertTrue(center.cancel(1));
        store(true);
        assertTrue(held.held() <= untried, "at most the report is left");
    }

    @Test
    void aRefusalIsNewsOnceUntilATenthHasLeft() {
        ShortMessage message =
                new ShortMessage(1, SENDER, RECEIVER, OctetString.ofHex("00"), Instant.EPOCH, Instant.EPOCH);
        for (int i = 0; i < 20; i++) {
            held.add(message);
        }
        assertTrue(held.isNewlyRefusing());
        assertFalse(held.isNewlyRefusing());
        held.remove(message);
        assertFalse(held.isNewlyRefusing(), "one of 20 has left");
        held.remove(message);
        assertTrue(held.isNewlyRefusing());
        assertFalse(held.isNewlyRefusing());
    }

    @Test
    void aSmallHeapRemembersLess() {
        assertEquals(6_710, HeapShare.count(100_000, 200, 64 << 20));
        assertEquals(100_000, HeapShare.count(100_000, 200, 2L << 30));
    }

    @Test
    void theLimitFollowsTheHeapAndASmallHeapAcceptsLess() {
        assertEquals(HeldOctets.in(1L << 30).most(), 2 * HeldOctets.in(1L << 29).most() + (24 << 20), 2);
        assertEquals(0, HeldOctets.in(1 << 20).most());
    }
}
