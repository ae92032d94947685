package simgsm.classroom.ui;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Actions of a class's window, called on the event thread. */
public interface ClassActions {
    /** Resets all results, puts the robots at their starts, and starts the clock. */
    void start();

    /** Stops the clock; later events do not count. */
    void stop();

    /**
     * Shows the recording from the beginning of a student's run.
     *
     * @throws IOException saying why it cannot be shown
     */
    void replay(String phone) throws IOException;

    /** The commands of the students' machines, a line each, in the order of their numbers; or the browsers' link. */
    List<String> commands();

    /** The command of all students, with N for the number; or the browsers' link. */
    String pattern();

    /** True if students open the link in a browser, and start no program. */
    boolean isInBrowsers();

    /** The reason why other machines cannot connect; empty if they can. */
    Optional<String> warning();
}
