package simgsm.phone.handset;

import simgsm.dtmf.ToneExperiment;
import simgsm.dtmf.ToneTrace;
import simgsm.dtmf.ToneTracer;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallMixer;

/** What is heard at the ear and seen on the scope: the far end's speech and one's own. */
final class Earpiece {
    private final AudioOutput output;
    private final ToneTracer tracer = new ToneTracer();
    private final CallMixer mix = new CallMixer();
    private boolean changed;

    Earpiece(AudioOutput output) {
        this.output = output;
    }

    /** 20 ms from the far end; heard with the next that is said. */
    void heard(short[] frame) {
        mix.received(frame);
    }

    /** 20 ms of one's own; it gives the beat. */
    void said(short[] frame) {
        short[] mixed = mix.sent(frame);
        output.play(mixed);
        changed |= tracer.accept(mixed);
    }

    /** Only the scope's picture is concerned. */
    void tryOut(ToneExperiment experiment) {
        tracer.tryOut(experiment);
        changed = true;
    }

    /** No sound comes for now. */
    void rest() {
        tracer.rest();
        changed = true;
    }

    void callEnded() {
        mix.clear();
    }

    ToneTrace trace() {
        return tracer.newest();
    }

    boolean isAudible() {
        return output.isAudible();
    }

    /** Whether the picture has changed since this was asked last. */
    boolean pollChanged() {
        boolean was = changed;
        changed = false;
        return was;
    }
}
