package simgsm.audio;

import java.util.concurrent.TimeUnit;
import simgsm.speech.SpeechCodec;

/**
 * Delays a sound, so that each of its frames reaches the device {@value #CUSHION_MILLIS} ms before it is played. The
 * time is taken from the caller's clock, as a device reports its remaining samples with errors of its whole buffer
 * (ALSA's plugin for PulseAudio). Only the first frame of a pause is written: the device runs empty, and the next
 * sound begins with a new cushion, which cancels the drift of the two clocks.
 */
final class SoundCushion {
    static final int CUSHION_MILLIS = 40;
    /** A frame that would raise the delay above this is dropped. */
    static final int MOST_MILLIS = 100;
    /** Twice the smallest value of A-law, for the sum of both directions. */
    private static final int SILENCE = 16;

    private static final short[] NOTHING = {};
    private static final long NANOS_PER_SAMPLE = TimeUnit.SECONDS.toNanos(1) / SpeechCodec.SAMPLES_PER_SECOND;

    /** Time at which the device will have played all its samples. */
    private long endNanos;

    private boolean pausing = true;

    /** A cushion for an idle device. */
    SoundCushion(long nowNanos) {
        endNanos = nowNanos;
    }

    /** Samples to write now, at 8 kHz: the frame after a cushion, the frame alone, or nothing, as for an empty frame. */
    short[] accept(short[] frame, long nowNanos) {
        long ahead = Math.max(0, endNanos - nowNanos);
        boolean silent = SpeechCodec.isSilent(frame, SILENCE);
        if (frame.length == 0 || silent && pausing || ahead > TimeUnit.MILLISECONDS.toNanos(MOST_MILLIS)) {
            return NOTHING;
        }
        long missing = pausing || ahead == 0 ? TimeUnit.MILLISECONDS.toNanos(CUSHION_MILLIS) - ahead : 0;
        int pause = (int) (Math.max(0, missing) / NANOS_PER_SAMPLE);
        short[] padded = new short[pause + frame.length];
        // Continues a late sound at its current sample, so that the gap is as short as possible.
        for (int i = pausing ? pause : 0; i < padded.length; i++) {
            padded[i] = frame[Math.floorMod(i - pause, frame.length)];
        }
        endNanos = nowNanos + ahead + padded.length * NANOS_PER_SAMPLE;
        pausing = silent;
        return padded;
    }
}
