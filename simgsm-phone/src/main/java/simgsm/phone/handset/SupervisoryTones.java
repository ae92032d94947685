package simgsm.phone.handset;

import java.util.ArrayList;
import java.util.List;
import simgsm.air.Cause;
import simgsm.dtmf.CadencePlayer;
import simgsm.dtmf.ProgressTone;
import simgsm.dtmf.ToneCadence;
import simgsm.dtmf.ToneSet;

/**
 * What the phone itself plays to tell how a call goes (TS 22.001, annex F), and its own ring. In GSM these sounds are not
 * sent: the phone makes them from the network's messages, unless the network says that it plays its own.
 */
final class SupervisoryTones {
    /** Our own ring: a warble of 20 changes a second, 1 s on, 2 s off. */
    private static final ToneCadence RING = ring();

    private static final int WARBLE_MILLIS = 50;
    /** As long as the network lets it ring, for it ends the call after that. */
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

    /** We are called. */
    void ringing() {
        player.start(RING, LONGEST_MILLIS);
    }

    /** Another calls while we talk: twice round its tone, which is enough to notice. */
    void callWaits() {
        player.start(set.cadence(ProgressTone.CALL_WAITING), WAITING_MILLIS);
    }

    /** The other phone rings. */
    void ringBack() {
        player.start(set.cadence(ProgressTone.RING_BACK), LONGEST_MILLIS);
    }

    /** A call has ended: what its cause sounds like, for some seconds; most sound like nothing. */
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
