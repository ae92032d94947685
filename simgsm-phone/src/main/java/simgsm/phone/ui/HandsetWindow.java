package simgsm.phone.ui;

import java.time.Clock;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.Timer;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.WindowIcon;

/** The window content of "Sim Cellular": the handset, updated from snapshots. */
public final class HandsetWindow {
    private static final int SECOND_MILLIS = 1000;

    private HandsetWindow() {}

    /** Called on the event thread. @param number the phone's own, for the title */
    public static ProgramWindow.Content content(
            String number,
            TextBundle texts,
            Locale language,
            Supplier<HandsetSnapshot> snapshots,
            HandsetControls controls) {
        HandsetPanel panel = new HandsetPanel(texts, language, Clock.systemDefaultZone(), snapshots.get(), controls);
        SnapshotPoller<HandsetSnapshot> newest = new SnapshotPoller<>(snapshots, panel::show);
        Timer clock = new Timer(SECOND_MILLIS, event -> panel.lookAtClock());
        newest.start();
        clock.start();
        return new ProgramWindow.Content(
                texts.of("window.title") + " " + number,
                texts.of("window.help"),
                WindowIcon.images(Symbol.PHONE),
                panel,
                Optional.empty(),
                Optional.empty(),
                Runnable::run,
                panel::requestFocusInWindow,
                () -> {
                    newest.stop();
                    clock.stop();
                });
    }
}
