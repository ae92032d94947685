package simgsm.phone.screen;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import simgsm.phone.screen.KeyIntent.Simple;

/** The pages, one over the other; without a page the home screen is shown. */
final class PageStack {
    private final Deque<Page> pages = new ArrayDeque<>();

    Optional<Page> top() {
        return Optional.ofNullable(pages.peek());
    }

    /** Shows a page over the others. */
    KeyIntent open(Page page) {
        top().ifPresent(Page::leave);
        pages.push(page);
        return Simple.NOTHING;
    }

    /** Takes the page away; the one below it is shown again. */
    KeyIntent close(Page page) {
        page.leave();
        pages.remove(page);
        return Simple.NOTHING;
    }

    /** Shows a page in another's place. */
    KeyIntent replace(Page page, Page by) {
        close(page);
        return open(by);
    }

    /** Shows the home screen. */
    KeyIntent home() {
        top().ifPresent(Page::leave);
        pages.clear();
        return Simple.NOTHING;
    }
}
