package simgsm.center.ui;

import java.util.Optional;
import javax.swing.Timer;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.console.TextBundle;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.WindowIcon;

/** What "SMSyCT" has in its window: a {@link MonitorPanel}, kept up to date. */
public final class MonitorWindow {
    private static final int RATE_PERIOD_MILLIS = 1_000;

    private MonitorWindow() {}

    /** Made on the event thread. */
    public static ProgramWindow.Content content(CenterActions operator, TextBundle texts) {
        MonitorPanel panel = new MonitorPanel(texts, operator);
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
                WindowIcon.images(Symbol.BROADCAST),
                panel,
                Optional.empty(),
                Optional.empty(),
                panel::requestFocusInWindow,
                () -> {
                    newest.stop();
                    seconds.stop();
                });
    }
}
