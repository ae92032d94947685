package simgsm.tools.audio;

import java.io.IOException;

/** Speech at 8 kHz out of a file, front to back. */
interface Samples {
    /** Fills {@code samples[from..to)} as far as there is sound. @return how many; fewer only at the end */
    int read(short[] samples, int from, int to) throws IOException;

    /** How much later than in an 8 kHz file a sample is known. */
    double lookAheadSeconds();
}
