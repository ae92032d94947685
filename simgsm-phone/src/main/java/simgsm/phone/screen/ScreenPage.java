package simgsm.phone.screen;

/** A page on the stack: its content and the functions of the keys, except the red key, which the handset handles. */
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

    /** Called before the page is covered by another or closed. */
    void leave() {}

    /** True if {@link #timePassed} must be called. */
    boolean wantsTime() {
        return false;
    }

    /** @return true if the page has changed */
    boolean timePassed(long nowNanos) {
        return false;
    }
}
