package simgsm.speech;

import java.util.function.Supplier;

/** An output that is opened when something is to be played for the first time. */
public final class LazyOutput implements AudioOutput {
    private final Supplier<AudioOutput> opener;
    private AudioOutput output = SILENT;
    private boolean asked;

    public LazyOutput(Supplier<AudioOutput> opener) {
        this.opener = opener;
    }

    @Override
    public synchronized void play(short[] samples) {
        if (!asked) {
            asked = true;
            output = opener.get();
        }
        output.play(samples);
    }

    @Override
    public synchronized boolean isAudible() {
        return output.isAudible();
    }

    @Override
    public synchronized void close() {
        asked = true;
        output.close();
    }
}
