package simgsm.station;

import java.util.Arrays;

/** What the station says in a call. */
@FunctionalInterface
public interface SpeechSource {
    SpeechSource SILENCE = frame -> Arrays.fill(frame, (short) 0);

    /** Fills the next 160 samples (8 kHz, 16 bit); asked every 20 ms from the moment a call is active. */
    void read(short[] frame);
}
