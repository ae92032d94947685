package simgsm.dtmf;

import java.util.Locale;

/**
 * A detected tone pair and the receiver's finding: published after each evaluation and once more after the end of the tones.
 *
 * @param fromSample the estimated start of the tones
 * @param toSample the number of samples received until the newest evaluation
 * @param finding accepted, or the requirement that failed
 * @param logOdds the sum that is compared with {@link #limit}; NaN if it was not computed
 * @param limit the sum of an accepted key is greater
 * @param measure the measure with the strongest evidence against a key, or the classic test that failed; empty if accepted
 * @param value that measure's value, in its unit
 * @param isOver whether the tones have ended or another key has begun
 */
public record KeyCandidate(
        DtmfKey key,
        long fromSample,
        long toSample,
        Finding finding,
        double logOdds,
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
        /** A test of the classic receiver failed. */
        TEST("%1$s %2$.1f");

        private final String text;

        Finding(String text) {
            this.text = text;
        }
    }

    public boolean isAccepted() {
        return finding == Finding.ACCEPTED || finding == Finding.PASSED;
    }

    KeyCandidate over() {
        return new KeyCandidate(key, fromSample, toSample, finding, logOdds, limit, measure, value, true);
    }

    /** The finding in English with the value that decided. */
    public String reason() {
        return String.format(Locale.ROOT, finding.text, measure, value, logOdds, limit);
    }
}
