package simrobot.app.batch;

import java.util.Locale;
import simgsm.console.Event;

/**
 * The end of one robot's process in a run.
 *
 * @param name of the process
 * @param seconds simulated time from the beginning of the run to the end of the process
 * @param meters travelled until then
 * @param text the reason, in English; empty if there is nothing to say
 */
record RunOutcome(String robot, String name, State state, double seconds, double meters, String text) {
    enum State {
        DONE,
        FAILED,
        COLLISION,
        TIMEOUT;

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    Event event() {
        return Event.of("outcome")
                .with("robot", robot)
                .with("name", name)
                .with("state", state.word())
                .with("seconds", threeDecimals(seconds))
                .with("meters", threeDecimals(meters))
                .with("text", text);
    }

    static String threeDecimals(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
