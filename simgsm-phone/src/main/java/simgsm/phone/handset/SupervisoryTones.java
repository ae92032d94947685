package simgsm.phone.handset;

import java.util.ArrayList;
import java.util.List;
import simgsm.air.Cause;
import simgsm.phone.screen.RingTone;
import simgsm.tone.CadencePlayer;
import simgsm.tone.ProgressTone;
import simgsm.tone.ToneCadence;
import simgsm.tone.ToneSet;

/**
 * The supervisory tones of a call (TS 22.001, annex F) and the ringing sound. In GSM the phone makes them from the
 * network's messages, unless the network announces its own.
 */
final class SupervisoryTones {
    private static final int RING_DBM0 = -13;
    private static final int WARBLE_MILLIS = 50;
    /** The network ends a call after ringing for this time. */
    private static final int LONGEST_MILLIS = 180_000;

    private static final int WAITING_MILLIS = 8_000;

    private final ToneSet set;
    private final CadencePlayer player = new CadencePlayer();

    SupervisoryTones(ToneSet set) {
        this.set = set;
    }

    /** A warble of 20 changes a second, 1 s on, 2 s off. */
    private static ToneCadence warble() {
        List<ToneCadence.Step> steps = new ArrayList<>();
        for (int millis = 0; millis < 1000; millis += 2 * WARBLE_MILLIS) {
            steps.add(ToneCadence.burst(WARBLE_MILLIS, RING_DBM0, 880.0));
            steps.add(ToneCadence.burst(WARBLE_MILLIS, RING_DBM0, 1175.0));
        }
        steps.add(ToneCadence.pause(2000));
        return new ToneCadence(steps);
    }

    /** Two rings of a bell, then 2 s of silence. */
    private static ToneCadence bell() {
        return new ToneCadence(List.of(
                ToneCadence.burst(400, RING_DBM0, 1000.0),
                ToneCadence.pause(200),
                ToneCadence.burst(400, RING_DBM0, 1000.0),
                ToneCadence.pause(2000)));
    }

    /** The notes of a chord, one after the other. */
    private static ToneCadence rising() {
        List<ToneCadence.Step> steps = new ArrayList<>();
        for (double hertz : new double[] {523.3, 659.3, 784.0, 1046.5}) {
            steps.add(ToneCadence.burst(160, RING_DBM0, hertz));
        }
        steps.add(ToneCadence.pause(1400));
        return new ToneCadence(steps);
    }

    /** An incoming call. */
    void ringing(RingTone tone) {
        player.stop();
        switch (tone) {
            case WARBLE -> player.start(warble(), LONGEST_MILLIS);
            case BELL -> player.start(bell(), LONGEST_MILLIS);
            case RISING -> player.start(rising(), LONGEST_MILLIS);
            case SILENT -> {}
        }
    }

    /** A second call is waiting: two periods of the tone. */
    void callWaits() {
        player.start(set.cadence(ProgressTone.CALL_WAITING), WAITING_MILLIS);
    }

    /** The called phone rings. */
    void ringBack() {
        player.start(set.cadence(ProgressTone.RING_BACK), LONGEST_MILLIS);
    }

    /** A call has ended: the tone of its cause for some seconds; most causes have none. */
    void ended(Cause cause) {
        player.stop();
        ProgressTone.ofCause(cause.code()).ifPresent(tone -> player.start(set.cadence(tone), millis(tone)));
    }

    private static int millis(ProgressTone tone) {
        return switch (tone) {
            case CALL_DROPPED -> 1_200; // Three bursts (TS 22.001, annex F).
            case CONGESTION -> 3_000;
            default -> 4_000;
        };
    }

    void stop() {
        player.stop();
    }

    boolean isIdle() {
        return player.isIdle();
    }

    /** Mixes the next 20 ms into the frame. */
    void addTo(short[] frame) {
        player.addTo(frame);
    }
}
