package simgsm.station;

import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;

/**
 * Options of a station.
 *
 * @param codec of the speech sent, A-law or GSM full rate; received speech may be either at any time
 * @param recorder receives the speech of all calls
 * @param callWaiting true if a second call may wait; else it is refused as busy
 * @param ignoresSetup a fault: the station answers paging, but not offered calls
 */
public record StationOptions(
        SpeechCodec.Kind codec, CallAudioListener recorder, boolean callWaiting, boolean ignoresSetup) {
    public static final StationOptions STANDARD = new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE);

    public StationOptions {
        if (codec == SpeechCodec.Kind.MU_LAW) {
            throw new IllegalArgumentException("expected A-law or GSM full rate, found mu-law");
        }
    }

    /** Without call waiting. */
    public StationOptions(SpeechCodec.Kind codec, CallAudioListener recorder) {
        this(codec, recorder, false);
    }

    /** Without the fault. */
    public StationOptions(SpeechCodec.Kind codec, CallAudioListener recorder, boolean callWaiting) {
        this(codec, recorder, callWaiting, false);
    }
}
