package simgsm.center.msc;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.dtmf.ProgressTone;
import simgsm.dtmf.ToneCadence;
import simgsm.dtmf.ToneSet;
import simgsm.timer.Timers;

/**
 * What one caller hears of the network itself while a call is not connected, if the network plays tones at all. As a rule
 * a GSM phone makes these sounds itself from the messages that it gets (TS 22.001, annex F); a network that plays its own
 * says so by progress indicator 8 in ALERTING (TS 24.008, 5.5.1) and in DISCONNECT (5.4.4.1.1).
 */
final class NetworkTones {
    private final Optional<ToneSet> set;
    private final ProgressSender sender;

    /** @param set empty for a network that leaves tones to the phones */
    NetworkTones(Optional<ToneSet> set, Link link, Timers timers) {
        this.set = set;
        sender = new ProgressSender(link, timers);
    }

    /** Whether the network plays ring-back. */
    boolean ring() {
        return set.isPresent();
    }

    /** Whether the network has a tone for a call that failed for this reason. */
    boolean has(Cause cause) {
        return failure(cause).isPresent();
    }

    /** Plays what belongs to this state of the call; nothing where nothing does. */
    void follow(NetworkCallState state, Cause cause, boolean announced) {
        Optional<ToneCadence> tone = Optional.empty();
        if (announced && state == NetworkCallState.CALL_DELIVERED) {
            tone = set.map(tones -> tones.cadence(ProgressTone.RING_BACK));
        } else if (announced && state == NetworkCallState.DISCONNECT_INDICATION) {
            tone = failure(cause);
        }
        tone.ifPresentOrElse(sender::play, sender::stop);
    }

    private Optional<ToneCadence> failure(Cause cause) {
        return set.flatMap(tones -> ProgressTone.ofCause(cause.code()).map(tones::cadence));
    }
}
