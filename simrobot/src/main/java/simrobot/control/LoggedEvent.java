package simrobot.control;

import java.util.Objects;

/**
 * Something that happened around one robot, for people to read later.
 *
 * @param timeNanos simulated time
 * @param what who or what it is about: a number, an order's keys, a status
 * @param text the rest: a reply's or a message's text, a verdict; empty when there is none
 */
public record LoggedEvent(long timeNanos, String robot, Kind kind, String what, String text) {
    /** What can happen. */
    public enum Kind {
        ADDED,
        REMOVED,
        REGISTERED,
        UNREGISTERED,
        CALL,
        ORDER,
        OUTCOME,
        REPLY,
        MESSAGE,
        RELEASED,
        STATUS,
        BEHAVIOUR
    }

    public LoggedEvent {
        Objects.requireNonNull(robot);
        Objects.requireNonNull(kind);
        Objects.requireNonNull(what);
        Objects.requireNonNull(text);
    }
}
