package simgsm.phone.ui;

import java.time.Clock;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.Timer;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.window.ProgramWindow;

/** The window content of "Sim Cellular": the handset, updated from snapshots. */
public final class HandsetWindow {
    private static final int SECOND_MILLIS = 1000;

    private final Function<Locale, TextBundle> bundles;
    private final Supplier<HandsetSnapshot> snapshots;
    private final HandsetControls controls;
    private final Consumer<Locale> speak;
    private HandsetFold fold = HandsetFold.NONE;

    /**
     * A window without content yet.
     *
     * @param bundles the texts in a language
     * @param speak rebuilds the content in the language set by the phone's user
     */
    public HandsetWindow(
            Function<Locale, TextBundle> bundles,
            Supplier<HandsetSnapshot> snapshots,
            HandsetControls controls,
            Consumer<Locale> speak) {
        this.bundles = bundles;
        this.snapshots = snapshots;
        this.controls = controls;
        this.speak = speak;
    }

    /** Called on the event thread. */
    public ProgramWindow.Content content(Locale language) {
        HandsetSnapshot first = snapshots.get();
        TextBundle texts = bundles.apply(language);
        HandsetView view = new HandsetView(texts, language, Clock.systemDefaultZone(), first, controls, speak);
        view.panel().open(fold);
        SnapshotPoller<HandsetSnapshot> newest = new SnapshotPoller<>(snapshots, view::show);
        Timer clock = new Timer(SECOND_MILLIS, event -> view.lookAtClock());
        newest.start();
        clock.start();
        return new ProgramWindow.Content(
                texts.of("window.title") + " " + first.own().digits(),
                texts.of("window.help"),
                Symbol.PHONE,
                view,
                Optional.empty(),
                Optional.empty(),
                Runnable::run,
                view::requestFocusInWindow,
                () -> {
                    fold = view.panel().fold();
                    newest.stop();
                    clock.stop();
                });
    }
}
