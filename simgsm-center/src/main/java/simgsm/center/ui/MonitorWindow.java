package simgsm.center.ui;

import java.util.Optional;
import java.util.concurrent.ExecutorService;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.console.TextBundle;
import simgsm.thread.DaemonThread;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.SuiteWindow;

/** The content of the window "SMSyCT": a {@link MonitorPanel} that shows the latest snapshot. */
public final class MonitorWindow {
    private static final int RATE_PERIOD_MILLIS = 1_000;

    private MonitorWindow() {}

    /** Creates the content; called on the event thread. */
    public static ProgramWindow.Content content(CenterActions operator, TextBundle texts) {
        ExecutorService worker = DaemonThread.executor("window actions");
        MonitorPanel panel = new MonitorPanel(texts, operator, new Background(worker, SwingUtilities::invokeLater));
        SnapshotPoller<ExchangeSnapshot> newest =
                new SnapshotPoller<>(() -> operator.snapshot().orElse(null), snapshot -> {
                    if (snapshot != null) {
                        panel.show(snapshot);
                    }
                });
        newest.start();
        Timer seconds = new Timer(RATE_PERIOD_MILLIS, event -> panel.tick(System.nanoTime()));
        seconds.start();
        return new ProgramWindow.Content(
                texts.of("window.title"),
                texts.of("window.help"),
                Symbol.BROADCAST,
                panel,
                Optional.empty(),
                Optional.of(SuiteWindow.CENTER.least()),
                Runnable::run,
                panel::requestFocusInWindow,
                () -> {
                    newest.stop();
                    seconds.stop();
                    worker.shutdown();
                });
    }
}
