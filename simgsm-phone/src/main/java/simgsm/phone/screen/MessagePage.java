package simgsm.phone.screen;

import simgsm.phone.screen.KeyIntent.Simple;
import simgsm.phone.store.Mailbox;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;

/** A message to read. */
final class MessagePage extends ScreenPage {
    /** Letters per line of the narrowest display. */
    private static final int LEAST_LETTERS = 16;

    private final Mailbox mailbox;
    private final MessagePages messages;
    private final MessageFolder folder;
    private StoredMessage message;
    private int scroll;

    MessagePage(PageStack stack, Mailbox mailbox, MessagePages messages, MessageFolder folder, StoredMessage message) {
        super(stack);
        this.mailbox = mailbox;
        this.messages = messages;
        this.folder = folder;
        this.message = message;
        mailbox.markRead(folder, message.serial());
    }

    private StoredMessage message() {
        message = mailbox.find(folder, message.serial()).orElse(message);
        return message;
    }

    @Override
    Screen screen() {
        return new Screen.MessageView(folder, message(), scroll);
    }

    @Override
    SoftKeys softKeys() {
        return new SoftKeys("soft.options", "soft.back");
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        return switch (key) {
            case UP -> KeyIntent.after(() -> scroll = Math.max(0, scroll - 1));
            case DOWN -> KeyIntent.after(() -> scroll = Math.min(lastScroll(), scroll + 1));
            case CALL -> messages.call(folder, message());
            case MESSAGE, OK -> messages.answer(folder, message());
            case SOFT_LEFT -> messages.options(folder, message(), this);
            case LEFT, MENU, SOFT_RIGHT, CLEAR -> stack.close(this);
            case HASH -> {
                mailbox.remove(folder, message());
                yield stack.close(this);
            }
            default -> Simple.NOTHING;
        };
    }

    /** The view stops earlier if all is shown. */
    private int lastScroll() {
        String text = message().text();
        return text.length() / LEAST_LETTERS
                + (int) text.chars().filter(sign -> sign == '\n').count();
    }
}
