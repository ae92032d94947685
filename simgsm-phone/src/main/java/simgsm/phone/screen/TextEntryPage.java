package simgsm.phone.screen;

/** A page for keying in a text; a pending letter becomes final when the page is covered or its second is over. */
abstract class TextEntryPage extends ScreenPage {
    final TextEntry entry;

    TextEntryPage(PageStack stack, TextEntry entry) {
        super(stack);
        this.entry = entry;
    }

    @Override
    boolean erase() {
        boolean hasText = !entry.text().isEmpty();
        entry.erase();
        return hasText;
    }

    /** Erases the character before the cursor; closes the page if there is none. */
    KeyIntent eraseOrClose() {
        return erase() ? KeyIntent.Simple.NOTHING : stack.close(this);
    }

    @Override
    void leave() {
        entry.commit();
    }

    @Override
    boolean wantsTime() {
        return entry.isPending();
    }

    @Override
    boolean timePassed(long nowNanos) {
        return entry.settle(nowNanos);
    }
}
