package simgsm.phone.screen;

/** A page on the stack: what it shows and what each key does on it. The red key is the handset's. */
abstract class ScreenPage {
    final PageStack stack;

    ScreenPage(PageStack stack) {
        this.stack = stack;
    }

    abstract Screen screen();

    abstract SoftKeys softKeys();

    abstract KeyIntent press(PhoneKey key, long nowNanos);

    /** A character from a keyboard. @return false if the page takes no text */
    boolean type(char character) {
        return false;
    }

    /** Erases the character before the cursor. @return false if there is none */
    boolean erase() {
        return false;
    }

    /** The page is covered by another, or leaves. */
    void leave() {}

    /** Whether {@link #timePassed} is to be called. */
    boolean wantsTime() {
        return false;
    }

    /** @return whether the page has changed */
    boolean timePassed(long nowNanos) {
        return false;
    }
}
