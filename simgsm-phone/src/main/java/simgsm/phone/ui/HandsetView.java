package simgsm.phone.ui;

import java.awt.BorderLayout;
import java.time.Clock;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.UserSettings;
import simgsm.ui.Theme;

/**
 * The handset in one language. The phone's and its window's settings of language and colours follow each other: the
 * last change is valid for both.
 */
public final class HandsetView extends JPanel {
    private final transient HandsetControls controls;
    private final transient Consumer<Locale> speak;
    private final HandsetPanel panel;
    private final Locale language;
    private Appearance appearance;
    /** True if the phone's language equals the view's; a later difference is the phone user's change. */
    private boolean isPhonesLanguage;

    /** @param speak rebuilds the window in another language */
    public HandsetView(
            TextBundle texts,
            Locale language,
            Clock clock,
            HandsetSnapshot first,
            HandsetControls controls,
            Consumer<Locale> speak) {
        super(new BorderLayout());
        this.controls = controls;
        this.speak = speak;
        this.language = language;
        panel = new HandsetPanel(texts, language, clock, first, controls);
        add(panel);
        appearance = Theme.appearance();
        tell();
    }

    /** Shows a newer snapshot. */
    public void show(HandsetSnapshot snapshot) {
        UserSettings settings = snapshot.settings();
        boolean isSame = settings.language().equals(code());
        if (isPhonesLanguage && !isSame) {
            isPhonesLanguage = false;
            speak.accept(Locale.forLanguageTag(settings.language()));
        }
        isPhonesLanguage |= isSame;
        if (Theme.appearance() == appearance && settings.appearance() != appearance) {
            dress(settings.appearance());
        }
        followWindow();
        panel.show(snapshot);
    }

    /** The language's code in the phone's settings. */
    private String code() {
        return TextBundle.bundleLocale(language).getLanguage().equals("es") ? "es" : "en";
    }

    private void dress(Appearance next) {
        appearance = next;
        Theme.install(next);
        var window = SwingUtilities.getWindowAncestor(this);
        Theme.refresh(window == null ? this : window);
    }

    private void followWindow() {
        if (Theme.appearance() != appearance) {
            appearance = Theme.appearance();
            tell();
        }
    }

    /** Sets the phone to the window's language and colours. */
    private void tell() {
        Appearance told = appearance;
        controls.perform((handset, now) ->
                handset.set(handset.snapshot().settings().withAppearance(told).withLanguage(code())));
    }

    /** Updates the display's clock; called about once a second. */
    public void lookAtClock() {
        panel.lookAtClock();
        followWindow();
    }

    HandsetPanel panel() {
        return panel;
    }

    @Override
    public boolean requestFocusInWindow() {
        return panel.requestFocusInWindow();
    }
}
