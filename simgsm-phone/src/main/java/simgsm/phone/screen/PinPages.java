package simgsm.phone.screen;

import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.Screen.Note;
import simgsm.sim.CardPin;
import simgsm.sim.PinLock;

/** The questions of a SIM to its user: the PIN, or the PUK and twice a new PIN (TS 22.030, 6.6.4). */
final class PinPages {
    private static final int MAX_DIGITS = 8;

    private final PageStack stack;
    private PinLock.State asked = PinLock.State.READY;

    PinPages(PageStack stack) {
        this.stack = stack;
    }

    /** Asks for what the card demands, in place of all other pages; leaves the question if it demands nothing. */
    KeyIntent ask(PinLock.Status card) {
        if (asked != PinLock.State.READY || !card.isReady()) {
            stack.home();
        }
        asked = card.state();
        return switch (card.state()) {
            case PIN ->
                open(Words.of("pin.enter", card.tries()), pin -> CardPin.isPin(pin) ? verify(pin) : wrongLength());
            case PUK ->
                open(Words.of("pin.puk", card.tries()), puk -> CardPin.isPuk(puk) ? newPin(puk) : wrongLength());
            case READY, BLOCKED -> Simple.NOTHING;
        };
    }

    private static KeyIntent verify(String pin) {
        return new KeyIntent.UseCard(lock -> lock.verify(pin));
    }

    private KeyIntent newPin(String puk) {
        return open(Words.of("pin.new"), pin -> CardPin.isPin(pin) ? again(puk, pin) : wrongLength());
    }

    private KeyIntent again(String puk, String pin) {
        return open(
                Words.of("pin.again"),
                second -> second.equals(pin)
                        ? new KeyIntent.UseCard(lock -> lock.unblock(puk, pin))
                        : note(Note.Kind.PIN_DIFFERS, ""));
    }

    /** In place of a code, 112 and 911 are called (TS 22.101, 10.1). */
    private KeyIntent open(Words title, Function<String, KeyIntent> done) {
        Function<String, KeyIntent> callOrCode =
                text -> new Msisdn(text).isEmergency() ? new KeyIntent.DialText(text) : done.apply(text);
        return stack.open(new EntryPage(stack, title, EntryPage.Kind.PIN, MAX_DIGITS, "soft.ok", callOrCode));
    }

    private KeyIntent wrongLength() {
        return note(Note.Kind.PIN_LENGTH, "");
    }

    private KeyIntent note(Note.Kind kind, String detail) {
        return stack.open(new NotePage(stack, new Note(kind, detail)));
    }

    /** The card has answered a code. */
    void answered(PinLock.Result result, PinLock.Status card) {
        boolean isBlocked = asked == PinLock.State.PIN && card.state() == PinLock.State.PUK;
        ask(card);
        switch (result) {
            case DONE -> note(Note.Kind.SAVED, "");
            case WRONG -> note(isBlocked ? Note.Kind.PIN_BLOCKED : Note.Kind.PIN_WRONG, String.valueOf(card.tries()));
            case REFUSED -> note(Note.Kind.REFUSED, "");
        }
    }
}
