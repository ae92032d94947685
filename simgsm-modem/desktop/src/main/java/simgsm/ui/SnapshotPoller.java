package simgsm.ui;

import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.Timer;

/**
 * Reads the newest snapshot 40 times a second and shows it if it is another object; slow painting skips snapshots.
 * Snapshots are published by another thread through a volatile or atomic reference.
 */
public final class SnapshotPoller<T> {
    private static final int PERIOD_MILLIS = 25;

    private final Supplier<T> source;
    private final Consumer<T> view;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> show());
    private T shown;

    public SnapshotPoller(Supplier<T> source, Consumer<T> view) {
        this.source = source;
        this.view = view;
        timer.setCoalesce(true);
    }

    public void start() {
        timer.start();
    }

    public void stop() {
        timer.stop();
    }

    /** Shows the newest snapshot now if not yet shown. */
    public void show() {
        T newest = source.get();
        if (newest != shown) {
            shown = newest;
            view.accept(newest);
        }
    }
}
