package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
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
        switch (key) {
            case LEFT -> entry.left();
            case RIGHT -> entry.right();
            case MENU, UP, DOWN -> entry.nextMode();
            case OK, CALL, MESSAGE -> {
                return entry.text().isEmpty() ? Simple.NOTHING : messages.chooseReceiver();
            }
            case SOFT_LEFT -> {
                return entry.text().isEmpty() ? Simple.NOTHING : options();
            }
            case SOFT_RIGHT, CLEAR -> {
                return erase() ? Simple.NOTHING : stack.close(this);
            }
            default -> key.tone().ifPresent(tone -> entry.tap(tone, nowNanos));
        }
        return Simple.NOTHING;
    }

    private KeyIntent options() {
        List<ListPage.ListItem> items = new ArrayList<>();
        ListPage page = ListPage.menu(stack, "soft.options", () -> items);
        items.add(page.closing("option.send", messages::chooseReceiver));
        items.add(page.closing("option.keep", () -> {
            stack.close(this);
            return messages.keepDraft();
        }));
        items.add(page.closing("option.clear", () -> {
            entry.clear();
            return Simple.NOTHING;
        }));
        return stack.open(page);
    }

    @Override
    boolean type(char character) {
        entry.type(character);
        return true;
    }
}
