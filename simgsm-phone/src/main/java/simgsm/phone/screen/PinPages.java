package simgsm.phone.screen;

import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.Screen.Note;
import simgsm.sim.CardPin;
import simgsm.sim.PinLock;

/** The questions of a SIM to its user: the PIN, or the PUK and twice a new PIN (TS 22.030, 6.6.4). */
final class PinPages {
    /** Room for a code that changes or unblocks the PIN. */
    private static final int MAX_SIGNS = 40;

    private final PageStack stack;
    private PinLock.Status asked = PinLock.none().status();

    PinPages(PageStack stack) {
        this.stack = stack;
    }

    /** Asks for what the card demands, in place of all other pages; leaves the question if it demands nothing. */
    KeyIntent ask(PinLock.Status card) {
        if (!asked.isReady() || !card.isReady()) {
            stack.home();
        }
        asked = card;
        return switch (card.state()) {
            case PIN ->
                stack.open(page(
                                Words.of("pin.enter", card.tries()),
                                pin -> CardPin.isPin(pin) ? verify(pin) : wrongLength())
                        .standing());
            case PUK ->
                stack.open(
                        page(Words.of("pin.puk", card.tries()), puk -> CardPin.isPuk(puk) ? newPin(puk) : wrongLength())
                                .standing());
            case READY, BLOCKED -> Simple.NOTHING;
        };
    }

    /** Asks again, with an empty line, for what the card still demands. */
    KeyIntent askAgain() {
        return ask(asked);
    }

    private static KeyIntent verify(String pin) {
        return new KeyIntent.UseCard(lock -> lock.verify(pin));
    }

    private KeyIntent newPin(String puk) {
        return stack.open(page(Words.of("pin.new"), pin -> CardPin.isPin(pin) ? again(puk, pin) : wrongLength()));
    }

    private KeyIntent again(String puk, String pin) {
        return stack.open(page(
                Words.of("pin.again"),
                second -> second.equals(pin)
                        ? new KeyIntent.UseCard(lock -> lock.unblock(puk, pin))
                        : note(Note.Kind.PIN_DIFFERS, "")));
    }

    /** In place of a code, 112 and 911 are called (TS 22.101, 10.1). */
    private EntryPage page(Words title, Function<String, KeyIntent> done) {
        Function<String, KeyIntent> callOrCode =
                text -> new Msisdn(text).isEmergency() ? new KeyIntent.DialText(text) : done.apply(text);
        return new EntryPage(stack, title, EntryPage.Kind.PIN, MAX_SIGNS, "soft.ok", callOrCode);
    }

    private KeyIntent wrongLength() {
        return note(Note.Kind.PIN_LENGTH, "");
    }

    private KeyIntent note(Note.Kind kind, String detail) {
        return stack.open(new NotePage(stack, new Note(kind, detail)));
    }

    /** The card has answered a code. */
    void answered(PinLock.Result result, PinLock.Status card) {
        boolean isBlocked = asked.state() == PinLock.State.PIN && card.state() == PinLock.State.PUK;
        ask(card);
        switch (result) {
            case DONE -> note(Note.Kind.SAVED, "");
            case WRONG -> note(isBlocked ? Note.Kind.PIN_BLOCKED : Note.Kind.PIN_WRONG, String.valueOf(card.tries()));
            case REFUSED -> note(Note.Kind.REFUSED, "");
        }
    }
}
