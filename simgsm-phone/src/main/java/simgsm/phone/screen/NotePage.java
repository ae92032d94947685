package simgsm.phone.screen;

/** A short notice; any key leaves. */
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
        return stack.close(this);
    }
}
