package simgsm.center.ui;

import java.io.IOException;
import java.util.Optional;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeSnapshot;

/**
 * What the window shows and does. Any thread may call these methods; those that change something may wait up to 5 s for the
 * centre, so the event thread must not call them, {@link #quit} aside.
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

    /** Shows the link by which browsers become phones, on the event thread; empty where there is none. */
    default Optional<Runnable> link() {
        return Optional.empty();
    }

    /** Ends the centre and the programs that it has started. */
    void quit();
}
