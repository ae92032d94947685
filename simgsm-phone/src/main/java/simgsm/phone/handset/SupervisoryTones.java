package simgsm.phone.handset;

import java.util.ArrayList;
import java.util.List;
import simgsm.air.Cause;
import simgsm.dtmf.CadencePlayer;
import simgsm.dtmf.ProgressTone;
import simgsm.dtmf.ToneCadence;
import simgsm.dtmf.ToneSet;

/**
 * The supervisory tones of a call (TS 22.001, annex F) and the ringing sound. In GSM the phone makes them from the network's
 * messages, unless the network announces tones of its own.
 */
final class SupervisoryTones {
    /** Our own ring: a warble of 20 changes a second, 1 s on, 2 s off. */
    private static final ToneCadence RING = ring();

    private static final int WARBLE_MILLIS = 50;
    /** The network ends a call that has rung this long. */
    private static final int LONGEST_MILLIS = 180_000;

    private static final int WAITING_MILLIS = 8_000;

    private final ToneSet set;
    private final CadencePlayer player = new CadencePlayer();

    SupervisoryTones(ToneSet set) {
        this.set = set;
    }

    private static ToneCadence ring() {
        List<ToneCadence.Step> steps = new ArrayList<>();
        for (int millis = 0; millis < 1000; millis += 2 * WARBLE_MILLIS) {
            steps.add(ToneCadence.burst(WARBLE_MILLIS, -13, 880.0));
            steps.add(ToneCadence.burst(WARBLE_MILLIS, -13, 1175.0));
        }
        steps.add(ToneCadence.pause(2000));
        return new ToneCadence(steps);
    }

    /** An incoming call. */
    void ringing() {
        player.start(RING, LONGEST_MILLIS);
    }

    /** A second call waits: two periods of the tone. */
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
