package simgsm.center.ui;

import java.io.IOException;
import java.util.Optional;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeSnapshot;

/** What the window may see and do. Any thread may call; nothing here blocks for long. */
public interface CenterActions {
    /** The port on which terminals are served. */
    int port();

    NetworkAccess access();

    /** The newest picture, at most a tenth of a second old; empty until the first one is there. */
    Optional<ExchangeSnapshot> snapshot();

    /**
     * Sends a text to everybody who is attached, now and perhaps again.
     *
     * @throws IllegalArgumentException saying what is wrong with the order
     */
    void broadcast(BroadcastOrder order);

    /** Ends a broadcast that is repeated; one that has ended already is left alone. */
    void stopBroadcast(int id);

    /**
     * Starts one more phone with a free number, as a process of its own that ends with the centre.
     *
     * @throws IOException saying why it could not be started
     */
    void newPhone() throws IOException;

    /** Starts one more SimRobot; as {@link #newPhone}. */
    void newRobot() throws IOException;

    /** Ends the centre and all that it has started. */
    void quit();
}
