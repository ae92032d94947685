package simgsm.phone.handset;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.KeyIntent.Simple;

/** The keys on the home screen: the number being typed, and keys that are held for a second function. */
final class HomeKeys {
    private static final int MAX_TYPED = 40;
    /** A key held this long does its second function: 1 opens the mailbox, 0 becomes a plus sign. */
    private static final long LONG_PRESS_NANOS = TimeUnit.MILLISECONDS.toNanos(800);

    private final ScreenNavigation screens;
    private String typed = "";
    private String lastNumber = "";
    private Optional<PhoneKey> held = Optional.empty();
    private long heldSinceNanos;

    HomeKeys(ScreenNavigation screens) {
        this.screens = screens;
    }

    String typed() {
        return typed;
    }

    void clear() {
        typed = "";
    }

    /** The number for redialling. */
    void setLastNumber(String number) {
        lastNumber = number;
    }

    /** A plus sign from a keyboard; it can only begin a number. */
    void plus() {
        typed = typed.isEmpty() ? "+" : typed;
    }

    void hold(PhoneKey key, long nowNanos) {
        held = Optional.of(key);
        heldSinceNanos = nowNanos;
    }

    void release(PhoneKey key) {
        held = held.filter(down -> down != key);
    }

    KeyIntent press(PhoneKey key, CallPhase phase) {
        return switch (key) {
            case CALL -> call(phase);
            case OK -> ok(phase);
            case END -> type("");
            case LEFT -> type(typed.substring(0, Math.max(0, typed.length() - 1)));
            case MENU -> screens.openMenu();
            case MESSAGE -> screens.write();
            case DOWN -> screens.open(MessageFolder.INBOX);
            case UP -> screens.open(MessageFolder.OUTBOX);
            case RIGHT -> Simple.NOTHING;
            default -> tone(key.tone().orElseThrow(), phase);
        };
    }

    private KeyIntent type(String number) {
        typed = number;
        return Simple.NOTHING;
    }

    private KeyIntent tone(DtmfKey tone, CallPhase phase) {
        if (phase == CallPhase.NONE && typed.length() < MAX_TYPED) {
            typed += tone.symbol();
        }
        return new KeyIntent.PlayTone(tone);
    }

    private KeyIntent ok(CallPhase phase) {
        if (phase == CallPhase.RINGING) {
            return Simple.ANSWER;
        }
        return typed.isEmpty() ? screens.openMenu() : call(phase);
    }

    private KeyIntent call(CallPhase phase) {
        if (phase != CallPhase.NONE) {
            return Simple.NOTHING;
        }
        return typed.isEmpty() ? type(lastNumber) : new KeyIntent.DialText(typed);
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
