package simgsm.sim;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The card's check of its user (TS 51.011, 8.9 to 8.13): PIN and PUK with their tries. Each change is kept before the
 * result is given, so a restart gives no new tries.
 */
public final class PinLock {
    /** The card's demand to its user. */
    public enum State {
        READY,
        PIN,
        PUK,
        BLOCKED
    }

    /** The card's answer to a command. */
    public enum Result {
        DONE,
        WRONG,
        /** The card has no PIN, or the command does not fit to its state. */
        REFUSED
    }

    /**
     * The state for displays and AT commands.
     *
     * @param pinTries left for the PIN, 0 to 3
     * @param pukTries left for the PUK, 0 to 10
     */
    public record Status(State state, boolean isEnabled, int pinTries, int pukTries) {
        public boolean isReady() {
            return state == State.READY;
        }

        /** Tries left for the code that the card demands; for the PIN if it demands none. */
        public int tries() {
            return state == State.PUK || state == State.BLOCKED ? pukTries : pinTries;
        }
    }

    /** Codes for the card (TS 22.030, 6.6.3): PIN and PUK, and those of a second PIN. */
    private static final Pattern CODE = Pattern.compile("\\*\\*0([45])(2?)\\*([0-9]*)\\*([0-9]*)\\*([0-9]*)#");

    private final Consumer<CardPin> keeper;
    /** Null for a card without a PIN. */
    private CardPin pin;

    private boolean isVerified;

    /** A card just switched on. @param keeper receives each change */
    public PinLock(Optional<CardPin> pin, Consumer<CardPin> keeper) {
        this.pin = pin.orElse(null);
        this.keeper = keeper;
    }

    /** A card that never asks for a PIN. */
    public static PinLock none() {
        return new PinLock(Optional.empty(), pin -> {});
    }

    /** The card is switched on: an enabled PIN is asked for again. */
    public void reset() {
        isVerified = false;
    }

    public Status status() {
        return pin == null
                ? new Status(State.READY, false, CardPin.TRIES, CardPin.PUK_TRIES)
                : new Status(state(), pin.isEnabled(), pin.tries(), pin.pukTries());
    }

    private State state() {
        if (pin.tries() == 0) {
            return pin.pukTries() == 0 ? State.BLOCKED : State.PUK;
        }
        return pin.isEnabled() && !isVerified ? State.PIN : State.READY;
    }

    /** VERIFY CHV; only an enabled PIN is verified. */
    public Result verify(String code) {
        return pin != null && pin.isEnabled() ? check(code) : Result.REFUSED;
    }

    /** CHANGE CHV; only an enabled PIN is changed (TS 51.011, 8.10). */
    public Result change(String old, String next) {
        Result result = verify(old);
        if (result == Result.DONE) {
            keep(pin.with(next, true));
        }
        return result;
    }

    /** ENABLE CHV or DISABLE CHV; without effect if it is so already. */
    public Result enable(boolean enabled, String code) {
        Result result = check(code);
        if (result == Result.DONE) {
            keep(pin.with(pin.pin(), enabled));
        }
        return result;
    }

    /** UNBLOCK CHV: gives the PIN this value, enables it and restores its tries; permitted in any state but BLOCKED. */
    public Result unblock(String code, String next) {
        if (pin == null || pin.pukTries() == 0) {
            return Result.REFUSED;
        }
        if (!code.equals(pin.puk())) {
            keep(pin.withTries(pin.tries(), pin.pukTries() - 1));
            return Result.WRONG;
        }
        isVerified = true;
        keep(pin.with(next, true).withTries(CardPin.TRIES, CardPin.PUK_TRIES));
        return Result.DONE;
    }

    /** True if a user has typed a code for the card and not for the network, such as **04*OLD*NEW*NEW#. */
    public static boolean isCode(String typed) {
        return CODE.matcher(typed).matches();
    }

    /** Performs such a code. The card has no second PIN; two different new PINs are refused, and no try is counted. */
    public Result perform(String typed) {
        Matcher code = CODE.matcher(typed);
        boolean isMeant = code.matches()
                && code.group(2).isEmpty()
                && CardPin.isPin(code.group(4))
                && code.group(4).equals(code.group(5));
        if (!isMeant) {
            return Result.REFUSED;
        }
        return code.group(1).equals("4") ? change(code.group(3), code.group(4)) : unblock(code.group(3), code.group(4));
    }

    /** Counts a try, and restores the count if the code is right. */
    private Result check(String code) {
        if (pin == null || pin.tries() == 0) {
            return Result.REFUSED;
        }
        if (!code.equals(pin.pin())) {
            keep(pin.withTries(pin.tries() - 1, pin.pukTries()));
            return Result.WRONG;
        }
        isVerified = true;
        if (pin.tries() < CardPin.TRIES) {
            keep(pin.withTries(CardPin.TRIES, pin.pukTries()));
        }
        return Result.DONE;
    }

    private void keep(CardPin next) {
        pin = next;
        keeper.accept(next);
    }
}
