package simgsm.classroom.ui;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** What the window of a class does. The event thread calls these methods. */
public interface ClassActions {
    /** Sets all results back, puts the robots where they began, and starts the clock. */
    void start();

    /** Stops the clock; what comes afterwards does not count. */
    void stop();

    /**
     * Shows the recording from the beginning of a student's run on.
     *
     * @throws IOException saying why it cannot be shown
     */
    void replay(String phone) throws IOException;

    /** What the students' machines start, a line each, in the order of their numbers. */
    List<String> commands();

    /** The same for all, with N for the number. */
    String pattern();

    /** What stands in the way of other machines; empty for nothing. */
    Optional<String> warning();
}
