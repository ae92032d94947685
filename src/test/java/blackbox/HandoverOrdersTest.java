package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import simgsm.speech.SpeechCodec;

/**
 * Handovers in the middle of orders by tones. Taps on the links of phone and robot tell which speech frames were lost, and so
 * which keys may be.
 */
class HandoverOrdersTest {
    /** {@code -Dhandovers=100} searches for longer; at other moments each time. */
    private static final int HANDOVERS = Integer.getInteger("handovers", 8);

    private static final String ORDER = "**#*#90**";
    private static final int DEGREES = 90;
    /** Two keys that belong to no order end the turn: the order's verdict is reported before the second. */
    private static final String END = "5";

    private static final int FRAME_MILLIS = 20;
    private static final int LONGEST_GAP_MILLIS = 200;
    /** Printed in place of a key that may have been lost. */
    private static final String UNREADABLE = "?";

    /** In samples of 16 bits; a tone has thousands, a pause next to nothing. */
    private static final int TONE_AMPLITUDE = 500;

    private static final int LARGEST_JUMP = 1_000;

    private final Random random = new Random();
    private final List<Turn> turns = new ArrayList<>();
    private final List<Integer> toldGapsMillis = new ArrayList<>();
    private int heading;

    /** One order, keyed while the phone was handed over, and what the robot made of it. */
    private record Turn(String heard, boolean isExecuted, boolean isReportedBroken, String told) {}

    @Test
    void aKeyIsLostInAGapOnlyAndItsOrderIsReportedBrokenOrNotBegunButNeverExecutedWrongly() throws Exception {
        try (Scenario scenario = new Scenario(HANDOVERS + " handovers in the middle of orders")) {
            scenario.center("--handover", "strongest-cell,margin=6,reports=1");
            RunningProgram cells = scenario.cells("village.town");
            String towers = "127.0.0.1:" + cells.said("ready").field("port");
            try (LinkTap phoneTap = new LinkTap(towers);
                    LinkTap robotTap = new LinkTap(towers)) {
                RunningProgram robot = scenario.robot("empty.map", "--center", robotTap.address());
                RunningProgram phone = scenario.phone(Scenario.PHONE, "--center", phoneTap.address());
                scenario.call(phone);
                for (int i = 0; i < HANDOVERS; i++) {
                    turns.add(turn(cells, phone, robot, i % 2 == 0 ? "3700" : "300"));
                }
                phone.say("hangup").expect("released");
                robot.expect("released");
                check(scenario, phoneTap, robotTap);
            }
        }
    }

    private Turn turn(RunningProgram cells, RunningProgram phone, RunningProgram robot, String x) {
        phone.say("press " + ORDER);
        int keysBefore = random.nextInt(ORDER.length() - 4);
        List<ConsoleEvent> events = new ArrayList<>();
        for (int i = 0; i < keysBefore; i++) {
            events.addAll(robot.expectAll("keys"));
        }
        cells.say("place " + Scenario.PHONE + " " + x + " 0");
        cells.expect("handover", "number", Scenario.PHONE, "result", "success");
        toldGapsMillis.add(
                (int) cells.expect("speech-gap", "number", Scenario.PHONE).number("millis"));
        phone.expect("sent", "keys", ORDER);
        phone.say("press " + END + END);
        events.addAll(robot.expectAll("keys", "keys", END));
        events.addAll(robot.expectAll("keys", "keys", END));
        boolean isAccepted = has(events, "order", "verdict", "accepted");
        if (isAccepted && !has(events, "outcome", "tone", "3")) {
            events.addAll(robot.expectAll("outcome"));
        }
        boolean isExecuted = isAccepted && has(events, "outcome", "tone", "3");
        heading = (heading + (isExecuted ? 360 - DEGREES : 0)) % 360;
        assertEquals(heading, robot.ask("pose", "pose").number("heading"), 0.005, () -> cells + "\n" + robot);
        String heard = events.stream()
                .filter(event -> event.name().equals("keys"))
                .map(event -> event.field("keys"))
                .filter(key -> !key.equals(UNREADABLE))
                .collect(Collectors.joining());
        return new Turn(heard, isExecuted, has(events, "outcome", "tone", "7"), events.toString());
    }

    private static boolean has(List<ConsoleEvent> events, String name, String key, String value) {
        return events.stream()
                .anyMatch(event ->
                        event.name().equals(name) && value.equals(event.fields().get(key)));
    }

    private void check(Scenario scenario, LinkTap phoneTap, LinkTap robotTap) {
        List<Integer> gapsMillis = gapsMillis(phoneTap.toTerminal());
        scenario.tell("speech gaps of the phone, in ms: " + gapsMillis);
        scenario.tell("as the cells told them: " + toldGapsMillis);
        scenario.tell("speech gaps of the robot, in ms: " + gapsMillis(robotTap.toTerminal()));
        List<Boolean> keysHit = keysHit(phoneTap.fromTerminal(), robotTap.toTerminal(), false);
        List<Boolean> pausesHit = keysHit(phoneTap.fromTerminal(), robotTap.toTerminal(), true);
        String keyed = ORDER + END + END;
        assertEquals(turns.size() * keyed.length(), keysHit.size(), "tones that left the phone");
        int lost = 0;
        int doubled = 0;
        int executed = 0;
        int broken = 0;
        for (int i = 0; i < turns.size(); i++) {
            Turn turn = turns.get(i);
            List<Boolean> hit = keysHit.subList(i * keyed.length(), (i + 1) * keyed.length());
            List<Boolean> pauseHit = pausesHit.subList(i * keyed.length(), (i + 1) * keyed.length());
            assertTrue(
                    isHeard(turn.heard, keyed, hit, pauseHit, 0, 0),
                    () -> "keyed " + keyed + ", in a gap " + hit + ", heard " + turn.heard + " in " + turn.told);
            boolean isWhole = turn.heard.equals(keyed);
            assertTrue(isWhole || !turn.isExecuted, () -> "executed though a key was lost or doubled: " + turn.told);
            // Without its first key an order has no beginning; then the robot has nothing to report.
            boolean isBegun = turn.heard.startsWith("**");
            assertTrue(
                    turn.isExecuted || turn.isReportedBroken || !isBegun, () -> "not reported as broken: " + turn.told);
            boolean isHit = hit.contains(true) || pauseHit.contains(true);
            assertFalse(isWhole && !turn.isExecuted && !isHit, () -> "not executed: " + turn.told);
            lost += Math.max(0, keyed.length() - turn.heard.length());
            doubled += Math.max(0, turn.heard.length() - keyed.length());
            executed += turn.isExecuted ? 1 : 0;
            broken += turn.isReportedBroken && isBegun ? 1 : 0;
        }
        scenario.tell(turns.size() + " orders: " + lost + " keys lost, " + doubled + " doubled, " + executed
                + " executed, " + broken + " reported as broken, " + (turns.size() - executed - broken) + " not begun");
        assertTrue(
                gapsMillis.stream().allMatch(millis -> millis <= LONGEST_GAP_MILLIS),
                () -> "speech gaps in ms " + gapsMillis);
    }

    /**
     * Whether these keys were heard: each of those keyed once and in order, but not, or twice, one whose tone a gap hit, and twice one
     * whose pause it hit, because the receiver puts a fading tone into the gap.
     */
    private static boolean isHeard(
            String heard, String keyed, List<Boolean> hit, List<Boolean> pauseHit, int from, int at) {
        if (at == keyed.length()) {
            return from == heard.length();
        }
        char key = keyed.charAt(at);
        int once = heard.startsWith("" + key, from) ? from + 1 : from;
        boolean isDoubled = (hit.get(at) || pauseHit.get(at)) && heard.startsWith("" + key + key, from);
        return once > from && isHeard(heard, keyed, hit, pauseHit, once, at + 1)
                || hit.get(at) && isHeard(heard, keyed, hit, pauseHit, from, at + 1)
                || isDoubled && isHeard(heard, keyed, hit, pauseHit, from + 2, at + 1);
    }

    /** The lengths of all runs of frames that a terminal missed. */
    private static List<Integer> gapsMillis(List<LinkTap.Speech> frames) {
        List<Integer> gaps = new ArrayList<>();
        for (int i = 1; i < frames.size(); i++) {
            int missed = frames.get(i).sequence() - frames.get(i - 1).sequence() - 1 & 0xffff;
            if (missed > 0
                    && missed < LARGEST_JUMP
                    && frames.get(i).source() == frames.get(i - 1).source()) {
                gaps.add(missed * FRAME_MILLIS);
            }
        }
        return gaps;
    }

    /** For each tone of the frames sent, whether one of its frames has not arrived, or one of the pause after it. */
    private static List<Boolean> keysHit(List<LinkTap.Speech> sent, List<LinkTap.Speech> arrived, boolean isOfPauses) {
        Set<Integer> heard = arrived.stream()
                .filter(frame -> frame.source() == sent.get(0).source())
                .map(LinkTap.Speech::sequence)
                .collect(Collectors.toCollection(HashSet::new));
        SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
        List<Boolean> hit = new ArrayList<>();
        boolean wasTone = false;
        for (LinkTap.Speech frame : sent) {
            boolean isTone = isTone(codec.decode(frame.payload()));
            if (isTone && !wasTone) {
                hit.add(false);
            }
            if (isTone != isOfPauses && !hit.isEmpty() && !heard.contains(frame.sequence())) {
                hit.set(hit.size() - 1, true);
            }
            wasTone = isTone;
        }
        return hit;
    }

    private static boolean isTone(short[] samples) {
        for (short sample : samples) {
            if (Math.abs(sample) > TONE_AMPLITUDE) {
                return true;
            }
        }
        return false;
    }
}
