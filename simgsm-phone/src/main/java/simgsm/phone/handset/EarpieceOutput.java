package simgsm.phone.handset;

import simgsm.phone.screen.UserSettings;
import simgsm.scope.ToneTrace;
import simgsm.scope.ToneTracer;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallMixer;
import simgsm.tone.ToneExperiment;

/** The sound of the earpiece and the tone scope: received speech mixed with the phone's own sound. */
final class EarpieceOutput {
    private static final double STEP_DB = 3;

    private final AudioOutput output;
    private final ToneTracer tracer = new ToneTracer();
    private final CallMixer mix = new CallMixer();
    private boolean changed;
    private double gain = 1;

    EarpieceOutput(AudioOutput output) {
        this.output = output;
    }

    /** 20 ms from the far end; mixed with the next frame of {@link #play}. */
    void receive(short[] frame) {
        mix.received(frame);
    }

    /** 20 ms of the phone's own sound; each call plays one frame. */
    void play(short[] frame) {
        short[] mixed = mix.sent(frame);
        output.play(atVolume(mixed));
        changed |= tracer.accept(mixed);
    }

    private short[] atVolume(short[] samples) {
        if (gain == 1) {
            return samples;
        }
        short[] scaled = new short[samples.length];
        for (int i = 0; i < samples.length; i++) {
            scaled[i] = (short) Math.round(gain * samples[i]);
        }
        return scaled;
    }

    /** Sets the earpiece's volume; the scope shows the sound before it. @param volume 0 to {@link UserSettings#MOST_VOLUME}, in steps of 3 dB */
    void setVolume(int volume) {
        double decibels = STEP_DB * (volume - UserSettings.MOST_VOLUME);
        gain = volume == 0 ? 0 : Math.pow(10, decibels / 20);
    }

    /** Sets the tone scope's experiment; the sound does not change. */
    void tryOut(ToneExperiment experiment) {
        tracer.tryOut(experiment);
        changed = true;
    }

    /** Tells the output that no sound follows for now. */
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

    /** True if the scope's picture has changed since the last call. */
    boolean pollChanged() {
        boolean was = changed;
        changed = false;
        return was;
    }
}
