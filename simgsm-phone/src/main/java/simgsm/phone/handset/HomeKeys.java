package simgsm.phone.handset;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.dtmf.DtmfKey;

/** The keys on the home screen: the number being typed, and what a key does when it is held. */
final class HomeKeys {
    private static final int MAX_TYPED = 40;
    /** A key held this long does its second task: 1 opens the mailbox, 0 becomes a plus sign. */
    private static final long LONG_PRESS_NANOS = TimeUnit.MILLISECONDS.toNanos(800);

    /** What these keys have done by the phone. */
    interface Deeds {
        void call(String number);

        void answer();

        /** The key goes down towards the far end or at the ear. */
        void sound(DtmfKey tone);

        void silence();
    }

    private final Screens screens;
    private final Deeds deeds;
    private String typed = "";
    private String lastNumber = "";
    private Optional<PhoneKey> held = Optional.empty();
    private long heldSinceNanos;

    HomeKeys(Screens screens, Deeds deeds) {
        this.screens = screens;
        this.deeds = deeds;
    }

    String typed() {
        return typed;
    }

    void clear() {
        typed = "";
    }

    /** What the green key brings back. */
    void remember(String number) {
        lastNumber = number;
    }

    /** A plus sign from a keyboard, which only begins a number. */
    void plus() {
        typed = typed.isEmpty() ? "+" : typed;
    }

    void hold(PhoneKey key, long nowNanos) {
        held = Optional.of(key);
        heldSinceNanos = nowNanos;
    }

    void letGo(PhoneKey key) {
        held = held.filter(down -> down != key);
    }

    void press(PhoneKey key, CallPhase phase) {
        switch (key) {
            case CALL -> call(phase);
            case OK -> ok(phase);
            case END -> typed = "";
            case LEFT -> typed = typed.substring(0, Math.max(0, typed.length() - 1));
            case MENU -> screens.openMenu();
            case MESSAGE -> screens.write();
            case DOWN -> screens.open(MessageFolder.INBOX);
            case UP -> screens.open(MessageFolder.OUTBOX);
            case RIGHT -> {}
            default -> key.tone().ifPresent(tone -> tone(tone, phase));
        }
    }

    private void tone(DtmfKey tone, CallPhase phase) {
        deeds.sound(tone);
        if (phase == CallPhase.NONE && typed.length() < MAX_TYPED) {
            typed += tone.symbol();
        }
    }

    private void ok(CallPhase phase) {
        if (phase == CallPhase.RINGING) {
            deeds.answer();
        } else if (typed.isEmpty()) {
            screens.openMenu();
        } else {
            call(phase);
        }
    }

    private void call(CallPhase phase) {
        if (phase == CallPhase.NONE && typed.isEmpty()) {
            typed = lastNumber;
        } else if (phase == CallPhase.NONE) {
            deeds.call(typed);
        }
    }

    boolean wantsTime(CallPhase phase) {
        return canBecomeLong(PhoneKey.ONE, "1", phase) || canBecomeLong(PhoneKey.ZERO, "0", phase);
    }

    private boolean canBecomeLong(PhoneKey key, String alone, CallPhase phase) {
        return held.equals(Optional.of(key)) && typed.equals(alone) && screens.isHome() && phase == CallPhase.NONE;
    }

    /** @return whether a long press was recognised */
    boolean timePassed(long nowNanos, CallPhase phase) {
        if (!wantsTime(phase) || nowNanos - heldSinceNanos < LONG_PRESS_NANOS) {
            return false;
        }
        deeds.silence();
        if (typed.equals("1")) {
            typed = "";
            screens.open(MessageFolder.INBOX);
        } else {
            typed = "+";
        }
        held = Optional.empty();
        return true;
    }
}
