package simgsm.center.msc.call;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.Cause;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallState;
import simgsm.center.msc.link.Link;
import simgsm.speech.SpeechCodec;
import simgsm.timer.Timer;
import simgsm.tone.CadencePlayer;
import simgsm.tone.ProgressTone;
import simgsm.tone.ToneCadence;
import simgsm.tone.ToneSet;

/**
 * Call progress tones of the network to one caller, in A-law frames of 20 ms, pauses included. A GSM phone usually
 * makes these tones itself (TS 22.001, annex F); a network with its own tones announces them by progress indicator 8 in
 * ALERTING (TS 24.008, 5.5.1) and DISCONNECT (5.4.4.1.1).
 */
final class NetworkTones {
    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    private static final int HOLD_DBM0 = -20;
    private static final long NANOS_PER_SAMPLE = 125_000;
    private static final ToneCadence HOLD = new ToneCadence(List.of(
            ToneCadence.burst(100, HOLD_DBM0, 425.0),
            ToneCadence.pause(100),
            ToneCadence.burst(100, HOLD_DBM0, 425.0),
            ToneCadence.pause(4_700)));
    /** The RTP source: "prog". */
    private static final int SOURCE = 0x70726f67;

    private final Optional<ToneSet> set;
    private final Link link;
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final CadencePlayer player = new CadencePlayer();
    private Timer next;
    private int sequence;
    private int timestamp;

    /** @param set empty for a network without tones */
    NetworkTones(Optional<ToneSet> set, Link link) {
        this.set = set;
        this.link = link;
        this.timestamp = (int) (link.timers().nowNanos() / NANOS_PER_SAMPLE);
    }

    boolean hasRingBack() {
        return set.isPresent();
    }

    /** True if there is a tone for a call that has failed for this cause. */
    boolean has(Cause cause) {
        return toneOf(cause).isPresent();
    }

    private Optional<ToneCadence> toneOf(Cause cause) {
        return set.flatMap(tones -> ProgressTone.ofCause(cause.code()).map(tones::cadence));
    }

    /** Plays ring-back, or the tone of the cause, until {@link #stop}. */
    void play(NetworkCallState state, Cause cause) {
        Optional<ToneCadence> tone = state == NetworkCallState.CALL_DELIVERED
                ? set.map(tones -> tones.cadence(ProgressTone.RING_BACK))
                : toneOf(cause);
        tone.ifPresent(cadence -> {
            player.start(cadence);
            frameDue();
        });
    }

    /** Plays the tone of a call that the other party holds, until {@link #stop}: two soft beeps every 5 s. */
    void playHold() {
        stop();
        player.start(HOLD);
        frameDue();
    }

    /** Plays the special information tone, until {@link #stop}: no number answers emergency calls. */
    void playNotice() {
        player.start(set.orElse(ToneSet.EUROPEAN).cadence(ProgressTone.SPECIAL_INFORMATION));
        frameDue();
    }

    void stop() {
        link.timers().cancel(next);
        player.stop();
    }

    private void frameDue() {
        next = link.timers().start(FRAME_NANOS, this::frameDue);
        short[] samples = new short[SpeechCodec.SAMPLES_PER_FRAME];
        player.addTo(samples);
        RtpPacket packet = new RtpPacket(
                RtpPacket.A_LAW, sequence++ & 0xffff, Integer.toUnsignedLong(timestamp), SOURCE, codec.encode(samples));
        timestamp += SpeechCodec.SAMPLES_PER_FRAME;
        link.access().sendSpeech(new IpaFrame(IpaFrame.SPEECH, packet.encode()));
    }
}
