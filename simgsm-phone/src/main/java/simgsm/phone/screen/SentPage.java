package simgsm.phone.screen;

import simgsm.phone.store.Mailbox;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;

/** The progress of a message that was just submitted. */
final class SentPage extends ScreenPage {
    private final Mailbox mailbox;
    private final MessagePages messages;
    private StoredMessage message;

    SentPage(PageStack stack, Mailbox mailbox, MessagePages messages, StoredMessage message) {
        super(stack);
        this.mailbox = mailbox;
        this.messages = messages;
        this.message = message;
    }

    private StoredMessage message() {
        message = mailbox.find(MessageFolder.OUTBOX, message.serial()).orElse(message);
        return message;
    }

    private boolean isFailed() {
        return message().delivery() == StoredMessage.Delivery.FAILED;
    }

    private boolean hasNews() {
        return mailbox.unread(MessageFolder.INBOX) > 0;
    }

    @Override
    Screen screen() {
        return new Screen.Sent(message());
    }

    @Override
    SoftKeys softKeys() {
        return new SoftKeys(isFailed() ? "soft.again" : hasNews() ? "soft.read" : "soft.ok", "soft.back");
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        boolean isChosen = key == PhoneKey.OK || key == PhoneKey.SOFT_LEFT;
        if (isChosen && isFailed()) {
            return MessagePages.sendAgain(message());
        }
        stack.close(this);
        return isChosen && hasNews() ? messages.open(MessageFolder.INBOX) : KeyIntent.Simple.NOTHING;
    }
}
