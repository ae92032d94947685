package simgsm.modem;

import java.util.Optional;
import simgsm.station.StationOptions;
import simgsm.words.Prompts;

/**
 * Options of a modem.
 *
 * @param answerAfterMillis ringing time before the answer, 0 to {@value #MAX_ANSWER_AFTER_MILLIS}
 * @param prompts replies are also said in words with these; empty for tones only
 * @param voices enrolled callers; empty for no orders by voice, which need prompts
 */
public record ModemOptions(
        StationOptions station, int answerAfterMillis, Optional<Prompts> prompts, Optional<VoiceStore> voices) {
    /** Real networks assign the speech channel meanwhile, and polling callers see the modem ringing. */
    public static final int DEFAULT_ANSWER_AFTER_MILLIS = 1500;

    /** The centre clears an unanswered call after 180 s. */
    public static final int MAX_ANSWER_AFTER_MILLIS = 120_000;

    public static final ModemOptions STANDARD = new ModemOptions(StationOptions.STANDARD, DEFAULT_ANSWER_AFTER_MILLIS);

    /** Replies by tones only. */
    public ModemOptions(StationOptions station, int answerAfterMillis) {
        this(station, answerAfterMillis, Optional.empty(), Optional.empty());
    }

    public ModemOptions {
        if (answerAfterMillis < 0 || answerAfterMillis > MAX_ANSWER_AFTER_MILLIS) {
            throw new IllegalArgumentException(
                    "expected 0 to " + MAX_ANSWER_AFTER_MILLIS + " ms of ringing, found " + answerAfterMillis);
        }
    }
}
