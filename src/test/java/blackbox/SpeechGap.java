package blackbox;

import static org.junit.jupiter.api.Assertions.assertTrue;

/**
 * The silence that the phone hears across a handover between the village's towers. It is measured by the clock, so another
 * program that holds the processor makes it longer, but not each time.
 */
public final class SpeechGap {
    private static final int MOST_MILLIS = 200;
    private static final int HANDOVERS = 5;

    private SpeechGap() {}

    /** The length in milliseconds, once the gap is over. */
    public static int of(RunningProgram cells) {
        return Integer.parseInt(
                cells.expect("speech-gap", "number", Scenario.PHONE).field("millis"));
    }

    /**
     * Requires a gap of 200 ms at most. After a longer one the phone, which stands at the eastern tower in a call, is carried to
     * and fro for up to five handovers, one of which must do.
     *
     * @param firstMillis the gap of the handover that has been
     */
    public static void requireShort(int firstMillis, RunningProgram cells) {
        int shortest = firstMillis;
        for (int i = 1; i < HANDOVERS && shortest > MOST_MILLIS; i++) {
            cells.say("place " + Scenario.PHONE + (i % 2 == 1 ? " 300 0" : " 3700 0"));
            cells.expect("handover", "number", Scenario.PHONE, "result", "success");
            shortest = Math.min(shortest, of(cells));
        }
        assertTrue(shortest <= MOST_MILLIS, "speech gap of " + shortest + " ms");
    }
}
