package simgsm.center.ui;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;

/** Runs blocking actions away from the event thread, and their completion on it. */
record Background(Executor worker, Executor eventThread) {
    /** Runs everything at once on the calling thread; for tests. */
    static final Background NONE = new Background(Runnable::run, Runnable::run);

    interface Action {
        void run() throws IOException;
    }

    /** @param completion receives the action's exception, if any */
    void run(Action action, Consumer<Optional<Exception>> completion) {
        worker.execute(() -> {
            Optional<Exception> failure = Optional.empty();
            try {
                action.run();
            } catch (IOException | RuntimeException e) {
                failure = Optional.of(e);
            }
            Optional<Exception> outcome = failure;
            eventThread.execute(() -> completion.accept(outcome));
        });
    }
}
