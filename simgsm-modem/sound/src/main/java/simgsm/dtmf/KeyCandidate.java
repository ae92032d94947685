package simgsm.dtmf;

import java.util.Locale;

/**
 * Two tones that stood out, and what a receiver made of them: published after each look and once more when they are over.
 *
 * @param fromSample where the tones began, estimated
 * @param toSample the number of samples that had come at the newest look
 * @param finding whether they are a key's, else what was missing
 * @param logOdds the sum that is compared with {@link #limit}; NaN where no look came so far
 * @param limit what the sum must exceed
 * @param measure the measure that spoke loudest against a key, or the classic test that failed; empty if accepted
 * @param value that measure's figure, in its unit
 * @param isOver whether the tones have ended, or another key has begun
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

    /** What came of a candidate. */
    public enum Finding {
        /** A key. */
        ACCEPTED("log odds %3$.1f over %4$.1f"),
        /** Sounded for less than a key must; the value is its length in milliseconds. */
        TOO_SHORT("too short, %2$.1f ms"),
        /** The level jumped or faded within the tones; the value is their length in milliseconds. */
        UNSTEADY("level not steady over %2$.1f ms"),
        /** Farther off a key's frequencies than Q.24 lets pass; the value is the larger error in percent. */
        OFF_FREQUENCY("off frequency, %2$.1f %%"),
        /** One tone much louder than the other; the value is high group over low in decibels. */
        TWIST("twist %2$.1f dB"),
        /** The key that ended last goes on without a pause. */
        ECHO("echo of the key before"),
        /** The evidence did not suffice. */
        EVIDENCE("log odds %3$.1f of %4$.1f, most against: %1$s %2$.2f"),
        /** A key, by the classic receiver's tests; the value is the number of blocks. */
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

    /** The finding in English with the figure that decided. */
    public String reason() {
        return String.format(Locale.ROOT, finding.text, measure, value, logOdds, limit);
    }
}
