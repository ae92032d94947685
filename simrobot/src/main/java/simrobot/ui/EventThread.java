package simrobot.ui;

import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Brings answers that come by any thread to the event thread. */
public final class EventThread {
    private EventThread() {}

    public static <T> Consumer<T> onEventThread(Consumer<T> view) {
        return answer -> {
            if (SwingUtilities.isEventDispatchThread()) {
                view.accept(answer);
            } else {
                SwingUtilities.invokeLater(() -> view.accept(answer));
            }
        };
    }
}
