package simgsm.phone.screen;

import java.util.List;
import java.util.function.Supplier;
import simgsm.phone.screen.KeyIntent.Simple;

/** Lines to read, or a question that the left key answers with yes. */
final class TextPage extends ScreenPage {
    private final Words title;
    private final Supplier<List<Words>> lines;
    private final SoftKeys softKeys;
    private final Supplier<KeyIntent> confirmed;

    private TextPage(
            PageStack stack,
            Words title,
            Supplier<List<Words>> lines,
            SoftKeys softKeys,
            Supplier<KeyIntent> confirmed) {
        super(stack);
        this.title = title;
        this.lines = lines;
        this.softKeys = softKeys;
        this.confirmed = confirmed;
    }

    static TextPage of(PageStack stack, Words title, Supplier<List<Words>> lines) {
        return new TextPage(stack, title, lines, SoftKeys.BACK, () -> Simple.NOTHING);
    }

    /** @param confirmed performed on yes, after the page is closed */
    static TextPage question(PageStack stack, Words question, Supplier<KeyIntent> confirmed) {
        return new TextPage(stack, Words.NONE, () -> List.of(question), new SoftKeys("soft.yes", "soft.no"), confirmed);
    }

    @Override
    Screen screen() {
        return new Screen.Details(title, lines.get());
    }

    @Override
    SoftKeys softKeys() {
        return softKeys;
    }

    @Override
    KeyIntent press(PhoneKey key, long nowNanos) {
        return switch (key) {
            case SOFT_LEFT, OK -> {
                stack.close(this);
                yield confirmed.get();
            }
            case SOFT_RIGHT, LEFT, CLEAR, MENU -> stack.close(this);
            default -> Simple.NOTHING;
        };
    }
}
