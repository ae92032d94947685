package simgsm.phone.ui;

import java.time.Clock;
import java.util.Locale;
import java.util.Optional;
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

    private HandsetWindow() {}

    /** Called on the event thread. @param bundles the texts in a language */
    public static ProgramWindow.Content content(
            Function<Locale, TextBundle> bundles, Supplier<HandsetSnapshot> snapshots, HandsetControls controls) {
        HandsetSnapshot first = snapshots.get();
        TextBundle texts = bundles.apply(Locale.forLanguageTag(first.settings().language()));
        HandsetView view = new HandsetView(bundles, Clock.systemDefaultZone(), first, controls);
        SnapshotPoller<HandsetSnapshot> newest = new SnapshotPoller<>(snapshots, view::show);
        Timer clock = new Timer(SECOND_MILLIS, event -> view.lookAtClock());
        newest.start();
        clock.start();
        return new ProgramWindow.Content(
                HandsetView.title(texts, first),
                texts.of("window.help"),
                Symbol.PHONE,
                view,
                Optional.empty(),
                Optional.empty(),
                Runnable::run,
                view::requestFocusInWindow,
                () -> {
                    newest.stop();
                    clock.stop();
                });
    }
}
