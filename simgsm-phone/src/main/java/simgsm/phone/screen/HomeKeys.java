package simgsm.phone.screen;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.store.CallRecord;
import simgsm.phone.store.MessageFolder;
import simgsm.station.context.StationEvent;

/** The keys on the home screen: the number being typed, calls, and second functions of keys that are held. */
public final class HomeKeys {
    /** The state that determines the keys of the home screen. */
    public record Situation(
            CallPhase phase, boolean ringIsSilent, boolean waits, boolean holds, int unread, int missed) {
        boolean isActive() {
            return phase == CallPhase.CONNECTED;
        }
    }

    private static final int MAX_TYPED = 40;
    /** Least time of a long press, for the second function: 1 opens the mailbox, 0 becomes a plus sign. */
    private static final long LONG_PRESS_NANOS = TimeUnit.MILLISECONDS.toNanos(800);

    private final ScreenNavigation screens;
    private final LineEditor typed = new LineEditor(MAX_TYPED);
    private Optional<PhoneKey> held = Optional.empty();
    private long heldSinceNanos;

    public HomeKeys(ScreenNavigation screens) {
        this.screens = screens;
    }

    public String typed() {
        return typed.text();
    }

    /** The number of digits before the cursor. */
    public int caret() {
        return typed.caret();
    }

    public void clear() {
        typed.set("");
    }

    /** A new call clears the display. */
    public void accept(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling || event instanceof StationEvent.Ringing) {
            clear();
            screens.home();
        } else if (event instanceof StationEvent.HoldRefused) {
            screens.note(Screen.Note.Kind.REFUSED, "");
        }
    }

    /** A plus sign from a keyboard; it can only begin a number. */
    public void plus() {
        if (typed.caret() == 0) {
            typed.insert('+');
        }
    }

    /** The keyboard's erase key. */
    public void erase() {
        typed.erase();
    }

    public void hold(PhoneKey key, long nowNanos) {
        held = Optional.of(key);
        heldSinceNanos = nowNanos;
    }

    public void release(PhoneKey key) {
        held = held.filter(down -> down != key);
    }

    public SoftKeys softKeys(Situation now) {
        return switch (now.phase()) {
            case RINGING -> new SoftKeys("soft.answer", now.ringIsSilent() ? "soft.refuse" : "soft.silence");
            case NONE -> {
                if (!typed.isEmpty()) {
                    yield new SoftKeys("soft.save", "soft.clear");
                }
                if (now.holds()) {
                    yield new SoftKeys("soft.retrieve", "soft.names");
                }
                yield new SoftKeys(
                        now.unread() > 0 ? "soft.read" : now.missed() > 0 ? "soft.show" : "soft.menu", "soft.names");
            }
            case CONNECTED ->
                new SoftKeys("soft.options", now.waits() ? "soft.take" : now.holds() ? "soft.swap" : "soft.hold");
            default -> new SoftKeys("soft.menu", "soft.names");
        };
    }

    public KeyIntent press(PhoneKey key, Situation now) {
        boolean isIdle = now.phase() == CallPhase.NONE;
        return switch (key) {
            case CALL -> call(now);
            case OK -> ok(now);
            case SOFT_LEFT, SOFT_RIGHT -> soft(key, now);
            case END -> KeyIntent.after(this::clear);
            case CLEAR -> KeyIntent.after(typed::erase);
            case LEFT -> KeyIntent.after(typed::left);
            case RIGHT -> KeyIntent.after(typed::right);
            case MENU -> screens.openMenu();
            case MESSAGE -> screens.messages.write();
            case DOWN -> isIdle ? screens.messages.open(MessageFolder.INBOX) : Simple.QUIETER;
            case UP -> isIdle ? screens.messages.open(MessageFolder.OUTBOX) : Simple.LOUDER;
            default -> tone(key.tone().orElseThrow(), now.phase());
        };
    }

    private KeyIntent soft(PhoneKey key, Situation now) {
        SoftKeys keys = softKeys(now);
        return switch (key == PhoneKey.SOFT_LEFT ? keys.left() : keys.right()) {
            case "soft.answer" -> Simple.ANSWER;
            case "soft.silence" -> Simple.SILENCE;
            case "soft.refuse" -> Simple.HANG_UP;
            case "soft.save" -> screens.names.save(typed());
            case "soft.clear" -> KeyIntent.after(typed::erase);
            case "soft.read" -> screens.messages.open(MessageFolder.INBOX);
            case "soft.show" -> screens.calls.open(CallRecord.Kind.MISSED);
            case "soft.names" -> screens.names.list();
            case "soft.hold", "soft.swap", "soft.take", "soft.retrieve" -> Simple.HOLD;
            case "soft.options" -> screens.openCallOptions(now);
            default -> screens.openMenu();
        };
    }

    private KeyIntent tone(DtmfKey tone, CallPhase phase) {
        if (phase == CallPhase.NONE) {
            typed.insert(tone.symbol());
        }
        return new KeyIntent.PlayTone(tone);
    }

    private KeyIntent ok(Situation now) {
        if (now.phase() == CallPhase.RINGING) {
            return Simple.ANSWER;
        }
        return typed.isEmpty() ? screens.openMenu() : call(now);
    }

    /**
     * Calls the number; without one, shows the numbers dialled before, the newest selected. With a second call, swaps
     * the two.
     */
    private KeyIntent call(Situation now) {
        if (now.phase() != CallPhase.NONE) {
            return now.isActive() && (now.waits() || now.holds()) ? Simple.HOLD : Simple.NOTHING;
        }
        if (typed.isEmpty() && now.holds()) {
            return Simple.HOLD;
        }
        return typed.isEmpty() ? screens.calls.open(CallRecord.Kind.DIALLED) : new KeyIntent.DialText(typed());
    }

    public boolean wantsTime(CallPhase phase) {
        return canBecomeLong(PhoneKey.ONE, "1", phase) || canBecomeLong(PhoneKey.ZERO, "0", phase);
    }

    private boolean canBecomeLong(PhoneKey key, String alone, CallPhase phase) {
        return held.equals(Optional.of(key)) && typed().equals(alone) && screens.isHome() && phase == CallPhase.NONE;
    }

    /** @return true if a long press was recognised */
    public boolean timePassed(long nowNanos, CallPhase phase) {
        if (!wantsTime(phase) || nowNanos - heldSinceNanos < LONG_PRESS_NANOS) {
            return false;
        }
        if (typed().equals("1")) {
            clear();
            screens.messages.open(MessageFolder.INBOX);
        } else {
            typed.set("+");
        }
        held = Optional.empty();
        return true;
    }
}
