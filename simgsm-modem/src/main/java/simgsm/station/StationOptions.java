package simgsm.station;

import simgsm.speech.SpeechCodec;

/**
 * How a station speaks.
 *
 * @param codec of the speech that it sends: A-law or GSM full rate; what it hears may be either at any time
 */
public record StationOptions(SpeechCodec.Kind codec) {
    public static final StationOptions STANDARD = new StationOptions(SpeechCodec.Kind.A_LAW);

    public StationOptions {
        if (codec == SpeechCodec.Kind.MU_LAW) {
            throw new IllegalArgumentException("mu-law is not spoken here (expected A-law or GSM full rate)");
        }
    }
}
