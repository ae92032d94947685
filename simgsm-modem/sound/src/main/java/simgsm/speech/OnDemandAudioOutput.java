package simgsm.speech;

import java.util.function.Supplier;

/** An output that is opened at the first frame to play. */
public final class OnDemandAudioOutput implements AudioOutput {
    private final Supplier<AudioOutput> opener;
    private AudioOutput output = SILENT;
    private boolean isOpened;

    public OnDemandAudioOutput(Supplier<AudioOutput> opener) {
        this.opener = opener;
    }

    @Override
    public synchronized void play(short[] samples) {
        if (!isOpened) {
            isOpened = true;
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
        isOpened = true;
        output.close();
    }
}
