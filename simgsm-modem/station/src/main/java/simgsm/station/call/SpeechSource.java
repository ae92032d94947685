package simgsm.station.call;

import java.util.Arrays;

/** The speech that a station sends in a call. */
@FunctionalInterface
public interface SpeechSource {
    SpeechSource SILENCE = frame -> Arrays.fill(frame, (short) 0);

    /** Fills the next 160 samples (8 kHz, 16 bit); called every 20 ms from the moment a call is active. */
    void read(short[] frame);

    /** The number of frames that were dropped before the last one read; the far end learns of them as of lost ones. */
    default int framesDropped() {
        return 0;
    }
}
