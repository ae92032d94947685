package simgsm.audio;

import java.util.concurrent.TimeUnit;
import simgsm.speech.SpeechCodec;

/**
 * Delays a sound, so that each of its frames reaches the device {@value #CUSHION_MILLIS} ms before it is
 * played. A device reports what it still has to play with errors of its whole buffer (ALSA's plugin for PulseAudio), so
 * the time is taken from the caller's clock. A pause is not written after its first frame: the device runs empty, and the
 * next sound begins with a new cushion, whatever the two clocks have drifted apart.
 */
final class SoundCushion {
    static final int CUSHION_MILLIS = 40;
    /** With more than this ahead of it a frame is left out. */
    static final int MOST_MILLIS = 100;
    /** Twice the smallest value of A-law, for the sum of both directions. */
    private static final int SILENCE = 16;

    private static final short[] NOTHING = {};
    private static final long NANOS_PER_SAMPLE = TimeUnit.SECONDS.toNanos(1) / SpeechCodec.SAMPLES_PER_SECOND;

    /** When the device has played all that it was given. */
    private long endNanos;

    private boolean pausing = true;

    /** A cushion for a device that has nothing to play. */
    SoundCushion(long nowNanos) {
        endNanos = nowNanos;
    }

    /** What the device has to be given now, at 8 kHz: the frame with a cushion before it, the frame alone, or nothing. */
    short[] accept(short[] frame, long nowNanos) {
        long ahead = Math.max(0, endNanos - nowNanos);
        boolean silent = isSilent(frame);
        if (silent && pausing || ahead > TimeUnit.MILLISECONDS.toNanos(MOST_MILLIS)) {
            return NOTHING;
        }
        long missing = pausing || ahead == 0 ? TimeUnit.MILLISECONDS.toNanos(CUSHION_MILLIS) - ahead : 0;
        int pause = (int) (Math.max(0, missing) / NANOS_PER_SAMPLE);
        short[] padded = new short[pause + frame.length];
        // A sound that came too late goes on as it is now, so that what is missing is no longer than it must be.
        for (int i = pausing ? pause : 0; i < padded.length; i++) {
            padded[i] = frame[Math.floorMod(i - pause, frame.length)];
        }
        endNanos = nowNanos + ahead + padded.length * NANOS_PER_SAMPLE;
        pausing = silent;
        return padded;
    }

    private static boolean isSilent(short[] frame) {
        for (short sample : frame) {
            if (Math.abs(sample) > SILENCE) {
                return false;
            }
        }
        return true;
    }
}
