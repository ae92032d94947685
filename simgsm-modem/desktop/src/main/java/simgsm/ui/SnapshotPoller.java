package simgsm.ui;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.Timer;

/**
 * Reads the newest snapshot 40 times a second and shows it if it is another object, so slow painting skips snapshots. While
 * there are few others it reads 5 times a second until a key or the mouse is pressed, which lets an idle processor sleep. The
 * snapshots come from another thread through a volatile or atomic reference.
 */
public final class SnapshotPoller<T> {
    private static final int PERIOD_MILLIS = 25;
    private static final int REST_MILLIS = 200;
    /** Looks in vain until rest: 2 s; each other snapshot takes 4 off, so a clock's one a second does not end a rest. */
    private static final int LOOKS_UNTIL_REST = 80;

    private static final int LOOKS_FOR_SNAPSHOT = 4;

    private final Supplier<T> source;
    private final Consumer<T> view;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> look());
    private final AWTEventListener pressed = event -> wake();
    private T shown;
    private int looksInVain;

    public SnapshotPoller(Supplier<T> source, Consumer<T> view) {
        this.source = source;
        this.view = view;
        timer.setCoalesce(true);
    }

    public void start() {
        Toolkit.getDefaultToolkit().addAWTEventListener(pressed, AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK);
        timer.start();
    }

    public void stop() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(pressed);
        timer.stop();
    }

    void look() {
        looksInVain =
                show() ? Math.max(0, looksInVain - LOOKS_FOR_SNAPSHOT) : Math.min(LOOKS_UNTIL_REST, looksInVain + 1);
        timer.setDelay(looksInVain < LOOKS_UNTIL_REST ? PERIOD_MILLIS : REST_MILLIS);
    }

    void wake() {
        looksInVain = 0;
        if (timer.getDelay() == REST_MILLIS) {
            timer.setDelay(PERIOD_MILLIS);
            timer.restart();
        }
    }

    int periodMillis() {
        return timer.getDelay();
    }

    /** Shows the newest snapshot now if it has not been shown. @return false if it has */
    public boolean show() {
        T newest = source.get();
        boolean isNew = newest != shown;
        if (isNew) {
            shown = newest;
            view.accept(newest);
        }
        return isNew;
    }
}
