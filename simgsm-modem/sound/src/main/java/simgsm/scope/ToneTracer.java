package simgsm.scope;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simgsm.dtmf.ClassicReceiver;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.ToneLevels;
import simgsm.speech.SpeechCodec;
import simgsm.tone.Disturber;
import simgsm.tone.ToneExperiment;
import simgsm.words.WordComparison;

/**
 * Makes a tone scope's {@link ToneTrace} from frames of sound. It has its own receivers, of the same kind as the
 * deciding one, so an experiment does not disturb others. Owned by one thread.
 */
public final class ToneTracer {
    /** A-law's smallest values count as silence. */
    private static final int SILENCE = 16;

    private final short[] samples = new short[ToneTrace.SAMPLES];
    private final ReceiverTracer modem = new ReceiverTracer(DtmfReceiver::new, this::samplesPassed);
    private final ReceiverTracer classic = new ReceiverTracer(
            (keys, candidates) -> new ClassicReceiver(keys, candidates, ClassicReceiver.SHORT_BLOCK),
            this::samplesPassed);
    private final List<ReceiverTracer> receivers = List.of(modem, classic);
    private final Disturber disturber = new Disturber();
    /** Receives the undisturbed sound during an experiment. */
    private final DtmfReceiver reference;

    private ToneExperiment experiment = ToneExperiment.NONE;
    private SoundStretch original = SoundStretch.EMPTY;
    private SoundStretch afterwards = SoundStretch.EMPTY;
    private long samplesPassed;
    private boolean silent = true;
    private Optional<WordComparison> word = Optional.empty();
    private ToneTrace newest = ToneTrace.EMPTY;

    public ToneTracer() {
        reference = new DtmfReceiver(heard -> {
            for (ReceiverTracer each : receivers) {
                each.scores().truth(heard.key(), samplesPassed);
            }
        });
    }

    private long samplesPassed() {
        return samplesPassed;
    }

    /** Sets the experiment for later frames and restarts the score. */
    public void tryOut(ToneExperiment newExperiment) {
        if (!newExperiment.equals(experiment)) {
            experiment = newExperiment;
            disturber.set(newExperiment);
            reference.reset();
            receivers.forEach(each -> each.scores().clear());
            publish();
        }
    }

    /** Accepts the next stretch of sound, at most 280 samples. @return true if the picture has changed */
    public boolean accept(short[] frame) {
        short[] kept = frame.clone();
        short[] heard = isExperiment() ? disturber.disturbed(frame) : kept;
        original = original.with(kept);
        afterwards = afterwards.with(heard);
        samplesPassed += frame.length;
        List<ToneScore> before = scores();
        if (isExperiment()) {
            reference.accept(frame);
        }
        for (ReceiverTracer each : receivers) {
            each.accept(heard);
            each.scores().timePassed(samplesPassed);
        }
        boolean changed = look(heard) || !before.equals(scores());
        if (changed) {
            publish();
        }
        return changed;
    }

    private boolean isExperiment() {
        return !experiment.equals(ToneExperiment.NONE);
    }

    private List<ToneScore> scores() {
        return List.of(modem.scores().score(), classic.scores().score());
    }

    /** @return true if the picture has changed */
    private boolean look(short[] heard) {
        boolean wasSilent = silent;
        int kept = samples.length - heard.length;
        System.arraycopy(samples, heard.length, samples, 0, kept);
        System.arraycopy(heard, 0, samples, kept, heard.length);
        silent = isSilent();
        return !(silent && wasSilent);
    }

    /** Ends the sound for now: the picture is quiet, and the last key remains. */
    public void rest() {
        Arrays.fill(samples, (short) 0);
        original = original.with(samples.clone());
        afterwards = afterwards.with(samples.clone());
        receivers.forEach(ReceiverTracer::rest);
        silent = true;
        publish();
    }

    /** Shows a key reported from elsewhere. */
    public void show(DtmfDigit reported) {
        modem.keyEnded(reported);
        publish();
    }

    /** Shows the comparison of a spoken word. */
    public void show(WordComparison compared) {
        word = Optional.of(compared);
        publish();
    }

    private void publish() {
        ReceiverTrace ours = modem.newest(isExperiment());
        ToneLevels before = isExperiment() && !silent ? reference.levels() : ours.levels();
        newest = new ToneTrace(original, afterwards, experiment, before, ours, classic.newest(isExperiment()), word);
    }

    private boolean isSilent() {
        return SpeechCodec.isSilent(samples, SILENCE) && !modem.isSounding() && !classic.isSounding();
    }

    public ToneTrace newest() {
        return newest;
    }

    /** Resets all but the experiment. */
    public void reset() {
        receivers.forEach(ReceiverTracer::reset);
        reference.reset();
        disturber.clear();
        Arrays.fill(samples, (short) 0);
        original = SoundStretch.EMPTY;
        afterwards = SoundStretch.EMPTY;
        silent = true;
        word = Optional.empty();
        if (isExperiment()) {
            publish();
        } else {
            newest = ToneTrace.EMPTY;
        }
    }
}
