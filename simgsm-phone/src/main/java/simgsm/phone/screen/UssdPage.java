package simgsm.phone.screen;

import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.ss.ServiceStatus;
import simgsm.station.context.StationEvent;

/** A USSD dialogue on the display. */
final class UssdPage extends ScreenPage {
    private final UnaryOperator<String> names;
    private final DisplayedUssd dialog = new DisplayedUssd();
    private Screen shown = new Screen.Ussd(Screen.Ussd.Phase.WAITING, "", "");

    /** @param names the name of a number */
    UssdPage(PageStack stack, UnaryOperator<String> names) {
        super(stack);
        this.names = names;
    }

    boolean awaitsNetwork() {
        return dialog.awaitsNetwork();
    }

    /** The user's text is sent. */
    void sent(String text) {
        dialog.sent(text);
        show();
    }

    void accept(StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived text) {
            dialog.received(text);
            show();
        } else if (event instanceof StationEvent.ServiceAnswered answer) {
            dialog.close();
            stack.replace(this, answerPage(answer.status()));
        } else if (event instanceof StationEvent.UssdEnded end) {
            Optional<Screen.Note> note = dialog.ended(end);
            if (dialog.screen().isEmpty()) {
                stack.close(this);
            }
            note.ifPresent(told -> stack.open(new NotePage(stack, told)));
        }
    }

    /** How a service stands, in words. */
    private TextPage answerPage(ServiceStatus status) {
        return TextPage.of(stack, ServiceWords.title(status), () -> ServiceWords.lines(status, names));
    }

    private void show() {
        if (stack.top().filter(page -> page == this).isEmpty()) {
            stack.close(this);
            stack.open(this);
        }
    }

    /** Ends the dialogue for the user, who goes home. */
    KeyIntent end() {
        dialog.close();
        stack.home();
        return Simple.END_USSD;
    }

    @Override
    Screen screen() {
        dialog.screen().ifPresent(screen -> shown = screen);
        return shown;
    }

    @Override
    SoftKeys softKeys() {
        Screen.Ussd screen = (Screen.Ussd) screen();
        return switch (screen.phase()) {
            case WAITING -> new SoftKeys("", "soft.cancel");
            case ASKED ->
                screen.reply().isEmpty() ? new SoftKeys("", "soft.cancel") : new SoftKeys("soft.reply", "soft.clear");
            case ANSWERED -> new SoftKeys("soft.ok", "");
        };
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        return switch (dialog.press(key)) {
            case SEND_REPLY ->
                new KeyIntent.SendUssd(dialog.screen().orElseThrow().reply());
            case LEAVE -> end();
            case NOTHING -> Simple.NOTHING;
        };
    }

    @Override
    boolean type(char character) {
        return dialog.type(character);
    }

    @Override
    boolean erase() {
        return dialog.erase();
    }
}
