package simgsm.tools.audio;

import java.io.IOException;

/** Speech at 8 kHz, read from a file in order. */
interface SampleSource {
    /** Fills {@code samples[from..to)}. @return the number of samples; fewer only at the end */
    int read(short[] samples, int from, int to) throws IOException;

    /** Look-ahead of the resampling filter. */
    double lookAheadSeconds();
}
