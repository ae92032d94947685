package simgsm.station;

import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;

/**
 * How a station speaks, and who listens in.
 *
 * @param codec of the speech that it sends: A-law or GSM full rate; what it hears may be either at any time
 * @param listener receives the speech of all calls
 */
public record StationOptions(SpeechCodec.Kind codec, CallAudioListener listener) {
    public static final StationOptions STANDARD = new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE);

    public StationOptions {
        if (codec == SpeechCodec.Kind.MU_LAW) {
            throw new IllegalArgumentException("mu-law is not spoken here (expected A-law or GSM full rate)");
        }
    }
}
