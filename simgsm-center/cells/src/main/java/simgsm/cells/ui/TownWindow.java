package simgsm.cells.ui;

import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.concurrent.ExecutorService;
import javax.swing.SwingUtilities;
import simgsm.cells.radio.Propagation;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.console.TextBundle;
import simgsm.thread.DaemonThread;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.SuiteWindow;

/** The content of the town's window: a {@link TownPanel} that shows the latest snapshot. */
public final class TownWindow {
    private TownWindow() {}

    /** The window's texts in the user's language. */
    public static TextBundle texts(Locale language) {
        return new TextBundle(
                ResourceBundle.getBundle("simgsm.cells.ui.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
    }

    /**
     * Creates the content; called on the event thread.
     *
     * @param town already has a snapshot
     * @param propagation of that town, with the core's seed
     */
    public static ProgramWindow.Content content(TownActions town, Propagation propagation, Locale language) {
        ExecutorService worker = DaemonThread.executor("coverage");
        TextBundle texts = texts(language);
        TownSnapshot first = town.snapshot();
        TownPanel panel = new TownPanel(texts, town, first, propagation, worker, SwingUtilities::invokeLater);
        SnapshotPoller<TownSnapshot> newest = new SnapshotPoller<>(town::snapshot, panel::show);
        newest.start();
        return new ProgramWindow.Content(
                texts.of("window.title", first.town().name()),
                texts.of("window.help"),
                Symbol.BROADCAST,
                panel,
                Optional.of(TownPanel.SIZE_UNITS),
                Optional.of(SuiteWindow.CELLS.least()),
                Runnable::run,
                panel::requestFocusInWindow,
                () -> {
                    newest.stop();
                    worker.shutdown();
                });
    }
}
