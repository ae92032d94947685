package simgsm.phone.screen;

import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.screen.Screen.Ussd;
import simgsm.phone.screen.Screen.Ussd.Phase;
import simgsm.ss.ServiceStatus;
import simgsm.ss.UssdText;
import simgsm.station.context.StationEvent;

/** A USSD dialogue on the display: the network's texts and the reply being typed. */
final class UssdPage extends ScreenPage {
    private static final Ussd CLOSED = new Ussd(Phase.ANSWERED, "", "");

    private final UnaryOperator<String> names;
    private Ussd shown = CLOSED;

    /** @param names the name of a number */
    UssdPage(PageStack stack, UnaryOperator<String> names) {
        super(stack);
        this.names = names;
    }

    boolean awaitsNetwork() {
        return shown.phase() == Phase.WAITING;
    }

    /** The user's text is sent. */
    void sent(String text) {
        show(new Ussd(Phase.WAITING, text, ""));
    }

    void accept(StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived text) {
            show(new Ussd(text.replyExpected() ? Phase.ASKED : Phase.ANSWERED, text.text(), ""));
        } else if (event instanceof StationEvent.ServiceAnswered answer) {
            shown = CLOSED;
            stack.replace(this, answerPage(answer.status()));
        } else if (event instanceof StationEvent.UssdEnded end) {
            if (shown.phase() != Phase.ANSWERED) {
                shown = CLOSED;
                stack.close(this);
            }
            Optional<Screen.Note> note = ServiceWords.noteOf(end);
            note.ifPresent(told -> stack.open(new NotePage(stack, told)));
        }
    }

    /** The state of a service in words. */
    private TextPage answerPage(ServiceStatus status) {
        return TextPage.of(stack, ServiceWords.title(status), () -> ServiceWords.lines(status, names));
    }

    private void show(Ussd next) {
        shown = next;
        if (stack.top().filter(page -> page == this).isEmpty()) {
            stack.close(this);
            stack.open(this);
        }
    }

    /** Ends the dialogue and shows the home screen. */
    KeyIntent end() {
        shown = CLOSED;
        stack.home();
        return Simple.END_USSD;
    }

    @Override
    Screen screen() {
        return shown;
    }

    @Override
    SoftKeys softKeys() {
        return switch (shown.phase()) {
            case WAITING -> new SoftKeys("", "soft.cancel");
            case ASKED ->
                shown.reply().isEmpty() ? new SoftKeys("", "soft.cancel") : new SoftKeys("soft.reply", "soft.clear");
            case ANSWERED -> new SoftKeys("soft.ok", "");
        };
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        if (shown.phase() != Phase.ASKED) {
            return shown.phase() == Phase.ANSWERED || key == PhoneKey.SOFT_RIGHT ? end() : Simple.NOTHING;
        }
        return switch (key) {
            case OK, CALL, SOFT_LEFT ->
                shown.reply().isEmpty() ? Simple.NOTHING : new KeyIntent.SendUssd(shown.reply());
            case LEFT, CLEAR -> KeyIntent.after(this::erase);
            case SOFT_RIGHT -> erase() ? Simple.NOTHING : end();
            default -> KeyIntent.after(() -> key.tone().ifPresent(tone -> type(tone.symbol())));
        };
    }

    @Override
    boolean type(char character) {
        boolean isAsked = shown.phase() == Phase.ASKED;
        if (isAsked && UssdText.fits(shown.reply() + character)) {
            shown = new Ussd(shown.phase(), shown.text(), shown.reply() + character);
        }
        return isAsked;
    }

    @Override
    boolean erase() {
        String reply = shown.reply();
        if (reply.isEmpty()) {
            return false;
        }
        shown = new Ussd(shown.phase(), shown.text(), reply.substring(0, reply.length() - 1));
        return true;
    }
}
