package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;

/** One answer of 10 000 is bad, late or missing: the other messages of the same number go on. */
class FaultyAnswersTest extends SmppStage {
    private static final int MESSAGES = 10_000;
    private static final int STEP_MILLIS = 10;
    private static final int PER_STEP = 2;
    /** Of the 2nd second; 200 messages a second come for 50 s. */
    private static final int FAULTY = 400;

    private static final int LARGEST_GAP_MILLIS = 100;

    /** The session's answer to one deliver_sm. */
    private interface Conduct {
        void answer(TestCenter.Application application, SmppPdu.Message delivery);
    }

    private final TestCenter.Application sender = sender();
    private final Map<TestCenter.Application, Conduct> conducts = new HashMap<>();
    private final Map<String, Integer> arrivals = new HashMap<>();
    private int millis;
    private int submitted;
    private int lastAcceptedMillis;
    private int largestGapMillis;

    private TestCenter.Application receiver(Conduct conduct) {
        TestCenter.Application receiver = receiver(SERVICE);
        conducts.put(receiver, conduct);
        return receiver;
    }

    private void submit(int count) {
        for (int i = 0; i < count && submitted < MESSAGES; i++) {
            sender.submit(++submitted, text("1", SERVICE, "m" + submitted));
        }
        network.commit();
        sender.heard.clear();
    }

    /** 10 ms: 2 messages come in, and the sessions answer all that they have heard. */
    private void step() {
        submit(PER_STEP);
        conducts.forEach((application, conduct) -> {
            Queue<SmppPdu> heard = new ArrayDeque<>(application.heard);
            application.heard.clear();
            for (SmppPdu pdu : heard) {
                if (pdu instanceof SmppPdu.Message delivery) {
                    conduct.answer(application, delivery);
                } else if (pdu instanceof SmppPdu.Plain request && request.command() == SmppCommand.ENQUIRE_LINK) {
                    application.say(
                            new SmppPdu.PlainResponse(SmppCommand.ENQUIRE_LINK, SmppStatus.OK, request.sequence()));
                }
            }
        });
        if (submitted < MESSAGES) {
            largestGapMillis = Math.max(largestGapMillis, millis - lastAcceptedMillis);
        }
        millis += STEP_MILLIS;
        network.timers.advance(millis * 1_000_000L);
    }

    private void accepted(TestCenter.Application application, SmppPdu.Message delivery) {
        lastAcceptedMillis = millis;
        arrivals.merge(textOf(delivery), 1, Integer::sum);
        application.answer(delivery, SmppStatus.OK);
    }

    private void runUntilSubmitted() {
        while (submitted < MESSAGES) {
            step();
        }
    }

    private boolean isTheFaultyOne(SmppPdu.Message delivery) {
        return textOf(delivery).equals("m" + FAULTY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0x64", "0x08", "0x58", "0x14"})
    void oneTemporaryRefusalDelaysThisMessageOnly(String status) {
        int[] refusals = {0};
        receiver((application, delivery) -> {
            if (isTheFaultyOne(delivery) && refusals[0]++ == 0) {
                application.answer(delivery, Integer.decode(status));
            } else {
                accepted(application, delivery);
            }
        });
        runUntilSubmitted();
        assertTrue(largestGapMillis <= LARGEST_GAP_MILLIS, "gap of " + largestGapMillis + " ms");
        IntStream.range(0, 6_500).forEach(i -> step());
        assertEquals(MESSAGES, arrivals.size());
        assertEquals(0, network.center.waitingCount());
    }

    @Test
    void oneMissingAnswerDelaysThisMessageOnly() {
        int[] omissions = {0};
        receiver((application, delivery) -> {
            if (!isTheFaultyOne(delivery) || omissions[0]++ > 0) {
                accepted(application, delivery);
            }
        });
        runUntilSubmitted();
        assertTrue(largestGapMillis <= LARGEST_GAP_MILLIS, "gap of " + largestGapMillis + " ms");
        IntStream.range(0, 6_500).forEach(i -> step());
        assertEquals(MESSAGES, arrivals.size());
        assertEquals(2, omissions[0], "it was sent again");
    }

    @Test
    void oneLateAnswerDelaysThisMessageOnly() {
        List<SmppPdu.Message> late = new ArrayList<>();
        receiver((application, delivery) -> {
            if (isTheFaultyOne(delivery) && late.isEmpty()) {
                late.add(delivery);
            } else {
                accepted(application, delivery);
            }
        });
        while (millis < 33_000) {
            step();
        }
        conducts.keySet().forEach(application -> application.answer(late.get(0), SmppStatus.OK));
        runUntilSubmitted();
        assertTrue(largestGapMillis <= LARGEST_GAP_MILLIS, "gap of " + largestGapMillis + " ms");
    }

    @Test
    void everyThousandthRefusedPermanentlyOrTemporarilyLeavesNoGap() {
        Set<String> refused = new HashSet<>();
        receiver((application, delivery) -> {
            int number = Integer.parseInt(textOf(delivery).substring(1));
            if (number % 1_000 == 0 && refused.add(textOf(delivery))) {
                application.answer(delivery, number % 2_000 == 0 ? SmppStatus.THROTTLED : SmppStatus.SUBMIT_FAILED);
            } else {
                accepted(application, delivery);
            }
        });
        runUntilSubmitted();
        assertTrue(largestGapMillis <= LARGEST_GAP_MILLIS, "gap of " + largestGapMillis + " ms");
    }

    @Test
    void ofTwoSessionsOnOneNumberTheHealthyOneServesWhileTheOtherIsStuck() {
        TestCenter.Application stuck = receiver((application, delivery) -> {});
        receiver(this::accepted);
        submit(4 * CircuitBreaker.MAX_FAILURES);
        runUntilSubmitted();
        assertTrue(largestGapMillis <= LARGEST_GAP_MILLIS, "gap of " + largestGapMillis + " ms");
        IntStream.range(0, 9_500).forEach(i -> step());
        assertEquals(MESSAGES, arrivals.size(), "what the stuck one has swallowed comes to the other");
        assertTrue(stuck.isEnding, "it has lost its bind");
    }

    @Test
    void aSessionThatAnswersNothingLosesItsTurnAfter30SecondsAndItsBindAfter2Minutes() {
        TestCenter.Application stuck = receiver((application, delivery) -> {});
        runUntilSubmitted();
        while (millis < 89_990) {
            step();
        }
        assertEquals(0, stuck.session().outstanding(), "nothing is sent to it");
        while (millis < 119_990) {
            step();
        }
        assertEquals(1, stuck.session().outstanding(), "one message tries whether it answers again");
        assertTrue(!stuck.isEnding);
        while (millis < 120_100) {
            step();
        }
        assertTrue(stuck.isEnding);
        assertEquals(MESSAGES, network.center.waitingCount());
        receiver(this::accepted);
        IntStream.range(0, 200).forEach(i -> step());
        assertEquals(MESSAGES, arrivals.size(), "absence alone stops the queue; a new bind ends it");
    }

    @Test
    void aSessionThatAnswersAgainGetsItsWholeWindowBack() {
        boolean[] isStuck = {true};
        receiver((application, delivery) -> {
            if (!isStuck[0]) {
                accepted(application, delivery);
            }
        });
        runUntilSubmitted();
        isStuck[0] = false;
        IntStream.range(0, 10_000).forEach(i -> step());
        assertEquals(MESSAGES, arrivals.size());
        assertEquals(0, network.center.waitingCount());
    }

    @ParameterizedTest
    @CsvSource({"0x58", "0x64"})
    void aSessionThatRefusesEverythingIsAskedWithOneMessageAfter1Then2Then4Seconds(String status) {
        List<Integer> times = new ArrayList<>();
        receiver((application, delivery) -> {
            times.add(millis);
            application.answer(delivery, Integer.decode(status));
        });
        runUntilSubmitted();
        int first = times.get(0);
        List<Integer> later =
                times.stream().filter(time -> time > first + 900).limit(4).toList();
        assertEquals(4, later.size());
        assertEquals(2_000, later.get(1) - later.get(0), 50);
        assertEquals(4_000, later.get(2) - later.get(1), 50);
        assertEquals(8_000, later.get(3) - later.get(2), 50);
        assertTrue(times.size() < 50, times.size() + " attempts");
    }
}
