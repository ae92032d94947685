package simgsm.center.ui;

import java.io.IOException;
import java.util.Optional;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeSnapshot;

/**
 * Content and actions of the window. Callable on any thread; methods that change something may wait up to 5 s for the
 * centre, so the event thread must not call them, except {@link #quit}.
 */
public interface CenterActions {
    /** The port on which terminals are served. */
    int port();

    NetworkAccess access();

    /** The latest snapshot, at most 0.1 s old; empty before the first. */
    Optional<ExchangeSnapshot> snapshot();

    /**
     * Sends a text to all attached subscribers, once or repeatedly.
     *
     * @throws IllegalArgumentException saying what is wrong with the order
     */
    void broadcast(BroadcastOrder order);

    /** Ends a repeated broadcast; without effect if it has ended. */
    void stopBroadcast(int id);

    /**
     * Starts another phone with a free number, in a process that ends with the centre.
     *
     * @throws IOException saying why it could not be started
     */
    void newPhone() throws IOException;

    /** Starts another SimRobot; as {@link #newPhone}. */
    void newRobot() throws IOException;

    /** Shows the link by which browsers become phones, on the event thread; empty if there is none. */
    default Optional<Runnable> link() {
        return Optional.empty();
    }

    /** Ends the centre and the programs started by it. */
    void quit();
}
