package simgsm.phone.screen;

import simgsm.phone.screen.KeyIntent.Simple;

/** A message being written. */
final class WritingPage extends TextEntryPage {
    private final MessagePages messages;

    WritingPage(PageStack stack, TextEntry entry, MessagePages messages) {
        super(stack, entry);
        this.messages = messages;
    }

    @Override
    Screen screen() {
        return new Screen.Writing(entry.text(), entry.caret(), entry.isPending(), entry.choices(), entry.mode());
    }

    @Override
    SoftKeys softKeys() {
        return entry.text().isEmpty() ? SoftKeys.BACK : new SoftKeys("soft.options", "soft.clear");
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        boolean isEmpty = entry.text().isEmpty();
        return switch (key) {
            case LEFT -> KeyIntent.after(entry::left);
            case RIGHT -> KeyIntent.after(entry::right);
            case MENU, UP, DOWN -> KeyIntent.after(entry::nextMode);
            case OK, CALL, MESSAGE -> isEmpty ? Simple.NOTHING : messages.chooseReceiver();
            case SOFT_LEFT -> isEmpty ? Simple.NOTHING : options();
            case SOFT_RIGHT, CLEAR -> eraseOrClose();
            default -> KeyIntent.after(() -> key.tone().ifPresent(tone -> entry.tap(tone, nowNanos)));
        };
    }

    private KeyIntent options() {
        return stack.open(ListPage.options(stack, Words.of("soft.options"))
                .option(true, "option.send", messages::chooseReceiver)
                .option(true, "option.keep", () -> {
                    stack.close(this);
                    return messages.keepDraft();
                })
                .option(true, "option.clear", () -> KeyIntent.after(entry::clear)));
    }

    @Override
    boolean type(char character) {
        entry.type(character);
        return true;
    }
}
