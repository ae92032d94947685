package simgsm.phone.ui;

import java.awt.BorderLayout;
import java.awt.Frame;
import java.time.Clock;
import java.util.Locale;
import java.util.function.Function;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.ui.Theme;

/**
 * The handset in the language and the colours that its user has set: another language makes the panel anew. Where the
 * colours are changed by the window, the setting follows them.
 */
public final class HandsetView extends JPanel {
    private final transient Function<Locale, TextBundle> bundles;
    private final transient Clock clock;
    private final transient HandsetControls controls;
    private HandsetPanel panel;
    private String language;
    private Appearance appearance;

    /** @param bundles the texts in a language */
    public HandsetView(
            Function<Locale, TextBundle> bundles, Clock clock, HandsetSnapshot first, HandsetControls controls) {
        super(new BorderLayout());
        this.bundles = bundles;
        this.clock = clock;
        this.controls = controls;
        appearance = Theme.appearance();
        speak(first);
        report();
    }

    /** Shows a newer snapshot. */
    public void show(HandsetSnapshot snapshot) {
        if (!snapshot.settings().language().equals(language)) {
            speak(snapshot);
        }
        if (Theme.appearance() != appearance) {
            report();
        } else if (snapshot.settings().appearance() != appearance) {
            dress(snapshot.settings().appearance());
        }
        panel.show(snapshot);
    }

    private void speak(HandsetSnapshot snapshot) {
        boolean isOpen = panel != null && panel.isScopeOpen();
        language = snapshot.settings().language();
        Locale locale = Locale.forLanguageTag(language);
        TextBundle texts = bundles.apply(locale);
        panel = new HandsetPanel(texts, locale, clock, snapshot, controls);
        removeAll();
        add(panel);
        if (isOpen) {
            panel.showScope();
        }
        revalidate();
        repaint();
        panel.requestFocusInWindow();
        if (SwingUtilities.getWindowAncestor(this) instanceof Frame frame) {
            frame.setTitle(title(texts, snapshot));
        }
    }

    /** The title of the window: the phone's name and number. */
    static String title(TextBundle texts, HandsetSnapshot snapshot) {
        return texts.of("window.title") + " " + snapshot.own().digits();
    }

    private void dress(Appearance next) {
        appearance = next;
        Theme.install(next);
        var window = SwingUtilities.getWindowAncestor(this);
        Theme.refresh(window == null ? this : window);
    }

    /** Sets the setting to the window's colours. */
    private void report() {
        appearance = Theme.appearance();
        Appearance reported = appearance;
        controls.perform(
                (handset, now) -> handset.set(handset.snapshot().settings().withAppearance(reported)));
    }

    /** Updates the display's clock; called about once a second. */
    public void lookAtClock() {
        panel.lookAtClock();
        if (Theme.appearance() != appearance) {
            report();
        }
    }

    @Override
    public boolean requestFocusInWindow() {
        return panel.requestFocusInWindow();
    }
}
