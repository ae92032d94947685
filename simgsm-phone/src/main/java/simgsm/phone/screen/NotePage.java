package simgsm.phone.screen;

/** A short notice; any key leaves, and a tone key belongs to the entry below. */
final class NotePage extends ScreenPage {
    private final Screen.Note note;

    NotePage(PageStack stack, Screen.Note note) {
        super(stack);
        this.note = note;
    }

    @Override
    Screen screen() {
        return note;
    }

    @Override
    SoftKeys softKeys() {
        return SoftKeys.OK;
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        KeyIntent left = stack.close(this);
        return stack.top()
                .filter(below -> below instanceof EntryPage && key.tone().isPresent())
                .map(below -> below.press(key, nowNanos))
                .orElse(left);
    }
}
