package simgsm.dtmf;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * A detected tone pair and the receiver's finding: published after each evaluation and once more after the end of the
 * tones.
 *
 * @param fromSample the estimated start of the tones
 * @param toSample the number of samples received until the newest evaluation
 * @param finding accepted, or the requirement that failed
 * @param score the log odds, or the number of tests passed in the classic receiver; NaN if not determined
 * @param limit the log odds of a key are greater, the number of tests equal
 * @param measure the name of the measure with the strongest evidence against a key; empty with other findings
 * @param value the deciding figure, in its unit
 * @param isOver true if the tones have ended or another key has begun
 */
public record KeyCandidate(
        DtmfKey key,
        long fromSample,
        long toSample,
        Finding finding,
        double score,
        double limit,
        String measure,
        double value,
        boolean isOver) {

    /** The result of an evaluation. */
    public enum Finding {
        /** A key. */
        ACCEPTED("log odds %3$.1f over %4$.1f"),
        /** Shorter than the minimum for a key; the value is the length in milliseconds. */
        TOO_SHORT("too short, %2$.1f ms"),
        /** The level changed too much within the tones; the value is their length in milliseconds. */
        UNSTEADY("level not steady over %2$.1f ms"),
        /** A frequency error above the limit of Q.24; the value is the larger error in percent. */
        OFF_FREQUENCY("off frequency, %2$.1f %%"),
        /** The tones' levels differ too much; the value is high group over low group in decibels. */
        TWIST("twist %2$.1f dB"),
        /** Continues the last key without a pause. */
        ECHO("echo of the key before"),
        /** The log odds are not above the limit. */
        EVIDENCE("log odds %3$.1f of %4$.1f, most against: %1$s %2$.2f"),
        /** Accepted by the classic receiver's tests; the value is the number of blocks. */
        PASSED("all tests passed in %2$.0f blocks"),
        /** The classic receiver: a tone is not prominent in its group; the value is its lead in decibels. */
        PEAK("%2$.1f dB over the others of its group"),
        /** The classic receiver: a tone has an overtone; the value is the tone's lead over it in decibels. */
        OVERTONE("%2$.1f dB over its second harmonic"),
        /** The classic receiver: other sound is too loud; the value is the tones' share of all power in percent. */
        SHARE("%2$.0f %% of all power"),
        /** The classic receiver: the tests passed in one block only. */
        ONE_BLOCK("all tests passed in one block only");

        private final String text;

        Finding(String text) {
            this.text = text;
        }
    }

    /** The possible names of {@link #measure}. */
    public static List<String> measures() {
        return Arrays.stream(KeyMeasures.Kind.values()).map(Enum::name).toList();
    }

    public boolean isAccepted() {
        return finding == Finding.ACCEPTED || finding == Finding.PASSED;
    }

    /** 0 to 1 at the limit, more for an accepted key: even odds are a half, as is half of the tests. */
    public double climbed() {
        if (Double.isNaN(score)) {
            return 0;
        }
        boolean isOdds = finding == Finding.EVIDENCE || finding == Finding.ACCEPTED;
        return Math.max(0, isOdds ? (score + limit) / (2 * limit) : score / limit);
    }

    KeyCandidate over() {
        return new KeyCandidate(key, fromSample, toSample, finding, score, limit, measure, value, true);
    }

    /** The finding in English with the deciding value. */
    public String reason() {
        return String.format(Locale.ROOT, finding.text, measure, value, score, limit);
    }
}
