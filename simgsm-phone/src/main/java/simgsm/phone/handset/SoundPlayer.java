package simgsm.phone.handset;

/** Adds a sound to the phone's speech, frame by frame. */
final class SoundPlayer {
    private short[] samples = {};
    private int next;
    private Runnable whenPlayed = () -> {};

    /** Replaces a sound being played. */
    void play(short[] sound, Runnable atEnd) {
        samples = sound;
        next = 0;
        whenPlayed = atEnd;
    }

    void stop() {
        samples = new short[0];
        next = 0;
    }

    boolean isIdle() {
        return next == samples.length;
    }

    /** Adds the next samples to both frames; sums are clipped to 16 bits. */
    void addTo(short[] speech, short[] heard) {
        if (isIdle()) {
            return;
        }
        for (int i = 0; i < speech.length && next < samples.length; i++) {
            speech[i] = sum(speech[i], samples[next]);
            heard[i] = sum(heard[i], samples[next]);
            next++;
        }
        if (isIdle()) {
            whenPlayed.run();
        }
    }

    private static short sum(short a, short b) {
        return (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, a + b));
    }
}
