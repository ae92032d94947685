package simgsm.phone.handset;

import java.util.List;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;

/** The handset's one call: how far it is, what was keyed and heard in it, for how long, and what it sounds like. */
final class PhoneCall {
    private static final int FRAMES_PER_SECOND = 50;

    private final Sounds sounds;
    private CallSnapshot call = CallSnapshot.NONE;
    private long frames;

    PhoneCall(Sounds sounds) {
        this.sounds = sounds;
    }

    CallPhase phase() {
        return call.phase();
    }

    /** The call as it is now. */
    CallSnapshot snapshot() {
        call = call.at((int) (frames / FRAMES_PER_SECOND));
        return call;
    }

    void began(CallPhase phase, String number) {
        call = CallSnapshot.begun(phase, number);
        frames = 0;
        sounds.callBegan();
        if (phase == CallPhase.RINGING) {
            sounds.ringing();
        }
    }

    void alerts() {
        call = call.in(CallPhase.ALERTING, call.number());
        sounds.ringBack();
    }

    void connected(Optional<String> number) {
        call = call.in(CallPhase.CONNECTED, number.orElse(call.number()));
        sounds.connected();
    }

    /** Another call waits beside this one. */
    void waits(String number) {
        call = call.withWaiting(Optional.of(number));
        sounds.callWaits();
    }

    void waitsNoMore() {
        call = call.withWaiting(Optional.empty());
        sounds.quiet();
    }

    void ended(Cause cause) {
        call = call.over(cause);
        sounds.callEnded(cause);
    }

    /** How the last call ended is known by now, and heard no more. */
    void forgetEnd() {
        call = call.withoutEnd();
        sounds.quiet();
    }

    /** Queues keys of 100 ms; before the call is connected they wait for it. */
    Optional<Refusal> press(List<DtmfKey> keys) {
        if (phase() == CallPhase.NONE) {
            return Optional.of(Refusal.NO_CALL);
        }
        if (phase() == CallPhase.RINGING) {
            return Optional.of(Refusal.NOT_ANSWERED);
        }
        sounds.press(keys);
        keys.forEach(this::keyed);
        return Optional.empty();
    }

    /** A key goes down, to sound until it goes up. */
    void down(DtmfKey key) {
        sounds.down(key);
        if (phase() == CallPhase.CONNECTED) {
            keyed(key);
        }
    }

    private void keyed(DtmfKey key) {
        call = call.withKeyed(key.symbol());
    }

    void toneHeard(DtmfKey key) {
        call = call.withHeard(key.symbol());
    }

    /** Fills the next 20 ms for the far end. @return whether what a view shows has changed */
    boolean say(short[] frame) {
        boolean soundChanged = sounds.say(frame);
        if (phase() != CallPhase.CONNECTED) {
            return soundChanged;
        }
        frames++;
        return soundChanged || frames % FRAMES_PER_SECOND == 0;
    }
}
