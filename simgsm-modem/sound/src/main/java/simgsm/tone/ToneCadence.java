package simgsm.tone;

import java.util.List;

/**
 * The repeated bursts and pauses of a call-progress tone. A single burst is a continuous tone.
 *
 * @param steps at least one; the first is a burst
 */
public record ToneCadence(List<Step> steps) {
    private static final int LONGEST_MILLIS = 3_600_000;

    /**
     * A burst, or a pause if it has no frequencies.
     *
     * @param millis at least 1
     * @param dbm0 level of each frequency, at most 3.14
     */
    public record Step(int millis, double dbm0, List<Double> hertz) {
        public Step {
            hertz = List.copyOf(hertz);
            if (millis < 1 || millis > LONGEST_MILLIS) {
                throw new IllegalArgumentException("Step of " + millis + " ms (expected 1 to " + LONGEST_MILLIS + ")");
            }
            if (!(dbm0 >= -100 && dbm0 <= ToneLevel.FULL_SCALE_DBM0)) {
                throw new IllegalArgumentException("Level of " + dbm0 + " dBm0 (expected -100 to 3.14)");
            }
            for (double each : hertz) {
                if (!(each > 0 && each < 4000)) {
                    throw new IllegalArgumentException("Tone of " + each + " Hz (expected above 0 and below 4000)");
                }
            }
        }

        boolean sounds() {
            return !hertz.isEmpty();
        }
    }

    public ToneCadence {
        steps = List.copyOf(steps);
        if (steps.isEmpty() || !steps.get(0).sounds()) {
            throw new IllegalArgumentException("A cadence begins with a burst");
        }
    }

    /** A burst of all these frequencies at once. */
    public static Step burst(int millis, double dbm0, Double... hertz) {
        return new Step(millis, dbm0, List.of(hertz));
    }

    public static Step pause(int millis) {
        return new Step(millis, 0, List.of());
    }

    boolean isContinuous() {
        return steps.size() == 1;
    }
}
