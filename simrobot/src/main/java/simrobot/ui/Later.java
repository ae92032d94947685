package simrobot.ui;

import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Brings answers that come by any thread to the event thread. */
final class Later {
    private Later() {}

    static <T> Consumer<T> onEventThread(Consumer<T> view) {
        return answer -> {
            if (SwingUtilities.isEventDispatchThread()) {
                view.accept(answer);
            } else {
                SwingUtilities.invokeLater(() -> view.accept(answer));
            }
        };
    }
}
