package simrobot.ui;

import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Passes answers from any thread to the event thread. */
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
