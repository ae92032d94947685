package simgsm.phone.screen;

import java.util.Optional;
import simgsm.dtmf.DtmfKey;
import simgsm.ss.UssdText;
import simgsm.station.context.StationEvent;

/** A USSD dialogue on the display: the network's texts and the reply being typed. */
final class DisplayedUssd {
    /** What a key asks for. */
    enum Wish {
        NOTHING,
        SEND_REPLY,
        /** The user is done with the text, or ends the dialogue. */
        LEAVE
    }

    private Optional<Screen.Ussd> shown = Optional.empty();

    /** The screen of the dialogue; empty without one. */
    Optional<Screen.Ussd> screen() {
        return shown;
    }

    boolean awaitsNetwork() {
        return shown.filter(screen -> screen.phase() == Screen.Ussd.Phase.WAITING)
                .isPresent();
    }

    /** The user's text is sent. */
    void sent(String text) {
        shown = Optional.of(new Screen.Ussd(Screen.Ussd.Phase.WAITING, text, ""));
    }

    void close() {
        shown = Optional.empty();
    }

    void received(StationEvent.UssdReceived text) {
        Screen.Ussd.Phase phase = text.replyExpected() ? Screen.Ussd.Phase.ASKED : Screen.Ussd.Phase.ANSWERED;
        shown = Optional.of(new Screen.Ussd(phase, text.text(), ""));
    }

    /** @return the note for the user, if there is something to tell */
    Optional<Screen.Note> ended(StationEvent.UssdEnded end) {
        boolean isRead = shown.filter(screen -> screen.phase() == Screen.Ussd.Phase.ANSWERED)
                .isPresent();
        if (!isRead) {
            shown = Optional.empty();
        }
        return ServiceWords.noteOf(end);
    }

    /** A character of the reply. @return false if none is expected */
    boolean type(char character) {
        if (shown.isEmpty() || shown.get().phase() != Screen.Ussd.Phase.ASKED) {
            return false;
        }
        setReply(shown.get().reply() + character);
        return true;
    }

    private void setReply(String reply) {
        Screen.Ussd screen = shown.orElseThrow();
        if (reply.isEmpty() || UssdText.fits(reply)) {
            shown = Optional.of(new Screen.Ussd(screen.phase(), screen.text(), reply));
        }
    }

    /** Erases the last character of the reply. @return false if there is none */
    boolean erase() {
        String reply = shown.map(Screen.Ussd::reply).orElse("");
        if (reply.isEmpty()) {
            return false;
        }
        setReply(reply.substring(0, reply.length() - 1));
        return true;
    }

    Wish press(PhoneKey key) {
        if (key == PhoneKey.END || shown.isEmpty()) {
            return Wish.LEAVE;
        }
        Screen.Ussd screen = shown.get();
        if (screen.phase() != Screen.Ussd.Phase.ASKED) {
            boolean leaves = screen.phase() == Screen.Ussd.Phase.ANSWERED || key == PhoneKey.SOFT_RIGHT;
            return leaves ? Wish.LEAVE : Wish.NOTHING;
        }
        switch (key) {
            case OK, CALL, SOFT_LEFT -> {
                return screen.reply().isEmpty() ? Wish.NOTHING : Wish.SEND_REPLY;
            }
            case LEFT, CLEAR -> erase();
            case SOFT_RIGHT -> {
                return erase() ? Wish.NOTHING : Wish.LEAVE;
            }
            default -> key.tone().map(DtmfKey::symbol).ifPresent(this::type);
        }
        return Wish.NOTHING;
    }
}
