package simgsm.phone.screen;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import simgsm.phone.screen.KeyIntent.Simple;

/** A stack of pages; the home screen is shown while it is empty. */
final class PageStack {
    private final Deque<ScreenPage> pages = new ArrayDeque<>();

    Optional<ScreenPage> top() {
        return Optional.ofNullable(pages.peek());
    }

    /** Shows a page above the others. */
    KeyIntent open(ScreenPage page) {
        top().ifPresent(ScreenPage::leave);
        pages.push(page);
        return Simple.NOTHING;
    }

    /** Removes the page; the one below is shown again. */
    KeyIntent close(ScreenPage page) {
        page.leave();
        pages.remove(page);
        return Simple.NOTHING;
    }

    /** Replaces a page by another. */
    KeyIntent replace(ScreenPage page, ScreenPage by) {
        close(page);
        return open(by);
    }

    /** Shows the home screen. */
    KeyIntent home() {
        top().ifPresent(ScreenPage::leave);
        pages.clear();
        return Simple.NOTHING;
    }
}
