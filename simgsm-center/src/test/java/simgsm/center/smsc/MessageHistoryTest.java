package simgsm.center.smsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/** What an operator sees of a message on its way: when it was tried, what it waits for, when it ends. */
class MessageHistoryTest {
    private static final Instant START = Instant.parse("2026-11-21T12:00:00Z");
    private static final Msisdn SENDER = new Msisdn("5550100");
    private static final Msisdn RECEIVER = new Msisdn("5550200");

    private final Timers timers = new Timers();
    private final Deque<Consumer<DeliveryOutcome>> underWay = new ArrayDeque<>();
    private final List<Tpdu> sent = new ArrayList<>();
    private final List<Long> tickets = new ArrayList<>();
    private boolean isThere = true;

    private final DeliveryPort port = new DeliveryPort() {
        @Override
        public boolean isReachable(Destination receiver) {
            return isThere;
        }

        @Override
        public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
            try {
                sent.add(TpduCodec.decode(envelope.tpdu(moreWaiting), Direction.DOWNLINK));
            } catch (ProtocolViolation violation) {
                throw new AssertionError(violation);
            }
            underWay.add(ended);
        }
    };

    private final ShortMessageCenter center = new ShortMessageCenter(
            new CivilTime(START, timers), timers, (ticket, entry) -> tickets.add(ticket), port, (message, state) -> {});

    private void submit(String text) {
        submit(text, Optional.empty());
    }

    private void submit(String text, Optional<ValidityPeriod> validity) {
        OctetString submit = TpduCodec.encode(
                new SubmitTpdu(false, true, false, 7, SmsAddress.of(RECEIVER), 0, validity, UserData.of(text)));
        center.submit(SENDER, submit, false, refusal -> assertEquals(Optional.empty(), refusal));
        store();
    }

    private void store() {
        List<Long> done = List.copyOf(tickets);
        tickets.clear();
        done.forEach(ticket -> center.committed(ticket, true));
    }

    private void passSeconds(long seconds) {
        timers.advance(timers.nowNanos() + Duration.ofSeconds(seconds).toNanos());
        store();
    }

    private void end(DeliveryOutcome outcome) {
        underWay.remove().accept(outcome);
        store();
    }

    private MessageHistory history(long id) {
        return center.messages().history(id).orElseThrow();
    }

    @Test
    void aMessageUnderWayAndTheOnesBehindIt() {
        submit("first");
        submit("second");
        assertEquals(WaitReason.UNDER_WAY, history(1).waitReason());
        assertEquals(WaitReason.BEHIND_OTHERS, history(2).waitReason());
        assertEquals(0, history(1).attemptCount());
    }

    @Test
    void aReceiverThatIsAwayIsWaitedFor() {
        isThere = false;
        submit("first");
        assertEquals(WaitReason.AWAITING_RECEIVER, history(1).waitReason());
        assertEquals(Optional.empty(), history(1).nextTry());
    }

    @Test
    void afterAFailureTheNextTryHasATime() {
        submit("first");
        passSeconds(10);
        end(DeliveryOutcome.FAILED);
        assertEquals(WaitReason.AWAITING_RETRY, history(1).waitReason());
        assertEquals(
                List.of(new DeliveryAttempt(START.plusSeconds(10), DeliveryOutcome.FAILED)),
                history(1).attempts());
        assertEquals(Optional.of(START.plusSeconds(70)), history(1).nextTry());
        passSeconds(60);
        assertEquals(WaitReason.UNDER_WAY, history(1).waitReason());
        end(DeliveryOutcome.ABSENT);
        assertEquals(Optional.of(START.plusSeconds(70 + 300)), history(1).nextTry());
        assertEquals(2, history(1).attemptCount());
    }

    @Test
    void aFullReceiverIsWaitedForAndTriedAtOnceWhenItHasRoom() {
        submit("first");
        end(DeliveryOutcome.MEMORY_FULL);
        assertEquals(WaitReason.AWAITING_MEMORY, history(1).waitReason());
        assertEquals(Optional.of(START.plusSeconds(60)), history(1).nextTry());
        center.available(RECEIVER);
        assertEquals(WaitReason.UNDER_WAY, history(1).waitReason());
        assertEquals(2, sent.size());
    }

    @Test
    void aBusyReceiverIsAskedAgainAfter1Then2Then4SecondsAndNeverAfterMoreThanAMinute() {
        submit("first");
        for (int pause : new int[] {1, 2, 4, 8, 16, 32, 60, 60}) {
            end(DeliveryOutcome.BUSY);
            Instant next = START.plusNanos(timers.nowNanos()).plusSeconds(pause);
            assertEquals(Optional.of(next), history(1).nextTry());
            passSeconds(pause);
        }
        end(DeliveryOutcome.DELIVERED);
        assertEquals(MessageState.DELIVERED, history(1).state());
    }

    @Test
    void theScheduleIsTheReceiversAndNotTheMessages() {
        submit("first");
        submit("second");
        end(DeliveryOutcome.FAILED);
        assertEquals(WaitReason.AWAITING_RETRY, history(1).waitReason());
        assertEquals(WaitReason.BEHIND_OTHERS, history(2).waitReason());
    }

    @Test
    void whatHasEndedIsRememberedWithItsAttempts() {
        submit("first");
        end(DeliveryOutcome.FAILED);
        passSeconds(60);
        end(DeliveryOutcome.DELIVERED);
        MessageHistory ended = history(1);
        assertEquals(MessageState.DELIVERED, ended.state());
        assertEquals(WaitReason.ENDED, ended.waitReason());
        assertEquals(
                List.of(DeliveryOutcome.FAILED, DeliveryOutcome.DELIVERED),
                ended.attempts().stream().map(DeliveryAttempt::outcome).toList());
        assertEquals(Optional.of(START.plusSeconds(60)), ended.endedAt());
        assertEquals(List.of(ended), center.messages().endedHistories(10));
    }

    @Test
    void theEndedAreRememberedUpToALimitAndTheNewestComesFirst() {
        for (int i = 0; i < MessageRegister.MAX_ENDED_HISTORIES + 5; i++) {
            submit("m" + i);
            end(DeliveryOutcome.DELIVERED);
            while (!underWay.isEmpty()) {
                end(DeliveryOutcome.DELIVERED);
            }
        }
        assertEquals(Optional.empty(), center.messages().history(5));
        assertTrue(center.messages().history(6).isPresent());
        assertEquals(
                MessageRegister.MAX_ENDED_HISTORIES + 5,
                center.messages().endedHistories(1).get(0).message().id());
    }

    @Test
    void onlyTheLatestAttemptsAreRememberedAndAllAreCounted() {
        submit("first");
        for (int i = 0; i < MessageHistory.MAX_ATTEMPTS + 3; i++) {
            end(DeliveryOutcome.FAILED);
            center.available(RECEIVER);
        }
        assertEquals(MessageHistory.MAX_ATTEMPTS, history(1).attempts().size());
        assertEquals(MessageHistory.MAX_ATTEMPTS + 3, history(1).attemptCount());
    }

    @Test
    void everyKindOfValidityEndsTheMessageAndIsReportedToTheSender() {
        isThere = false;
        Timestamp inAnHour = Timestamp.of(START.plusSeconds(3_600).atOffset(java.time.ZoneOffset.UTC));
        submit("five minutes", Optional.of(new ValidityPeriod.Relative(0)));
        submit("an hour", Optional.of(new ValidityPeriod.Absolute(inAnHour)));
        submit("30 seconds", Optional.of(new ValidityPeriod.Enhanced(OctetString.ofHex("021e0000000000"))));
        submit("2 h 3 min 4 s", Optional.of(new ValidityPeriod.Enhanced(OctetString.ofHex("03203040000000"))));
        submit("a week by default");
        assertEquals(
                List.of(300L, 3_600L, 30L, 7_384L, 604_800L),
                center.messages().waitingHistories(10).stream()
                        .map(each -> Duration.between(START, each.message().expiresAt())
                                .toSeconds())
                        .toList());
        passSeconds(29);
        assertEquals(MessageState.ACCEPTED, history(3).state());
        passSeconds(1);
        assertEquals(MessageState.EXPIRED, history(3).state());
        passSeconds(7_384);
        assertEquals(1, center.messages().waitingHistories(10).size());
        isThere = true;
        center.available(SENDER);
        StatusReportTpdu report = (StatusReportTpdu) sent.get(sent.size() - 1);
        assertEquals(DeliveryStatus.VALIDITY_EXPIRED, report.status());
        assertEquals(7, report.reference());
    }

    @Test
    void aMessageThatHasExpiredOnArrivalIsGivenUpAtOnce() {
        isThere = false;
        submit(
                "too late",
                Optional.of(new ValidityPeriod.Absolute(
                        Timestamp.of(START.minusSeconds(60).atOffset(java.time.ZoneOffset.UTC)))));
        passSeconds(0);
        assertEquals(MessageState.EXPIRED, history(1).state());
    }

    @Test
    void messagesStayInOrderAfterFailures() {
        for (int i = 0; i < 5; i++) {
            submit("m" + i);
        }
        end(DeliveryOutcome.DELIVERED);
        end(DeliveryOutcome.FAILED);
        passSeconds(60);
        while (!underWay.isEmpty()) {
            end(DeliveryOutcome.DELIVERED);
        }
        assertEquals(
                List.of("m0", "m1", "m1", "m2", "m3", "m4"),
                sent.stream()
                        .filter(DeliverTpdu.class::isInstance)
                        .map(tpdu -> ((DeliverTpdu) tpdu).userData().text())
                        .toList());
    }
}
