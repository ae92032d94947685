package simgsm.phone.screen;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import simgsm.phone.screen.KeyIntent.Simple;

/** The pages, one over the other; without a page the home screen is shown. */
final class PageStack {
    private final Deque<ScreenPage> pages = new ArrayDeque<>();

    Optional<ScreenPage> top() {
        return Optional.ofNullable(pages.peek());
    }

    /** Shows a page over the others. */
    KeyIntent open(ScreenPage page) {
        top().ifPresent(ScreenPage::leave);
        pages.push(page);
        return Simple.NOTHING;
    }

    /** Takes the page away; the one below it is shown again. */
    KeyIntent close(ScreenPage page) {
        page.leave();
        pages.remove(page);
        return Simple.NOTHING;
    }

    /** Shows a page in another's place. */
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
