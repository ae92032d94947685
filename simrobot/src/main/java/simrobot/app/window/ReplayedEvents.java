package simrobot.app.window;

import java.util.Optional;
import simgsm.console.CommandException;
import simgsm.console.Event;
import simrobot.control.LoggedEvent;
import simrobot.control.RobotEventLog;
import simrobot.replay.RecordedEvent;

/** Recorded console lines as events of the window's log. */
final class ReplayedEvents {
    private ReplayedEvents() {}

    /** Empty for events that the log does not keep. */
    static Optional<LoggedEvent> of(RecordedEvent recorded) {
        try {
            return Optional.of(Event.parse(recorded.line()))
                    .filter(RobotEventLog::keeps)
                    .map(line -> new LoggedEvent(recorded.timeNanos(), line));
        } catch (CommandException damaged) {
            return Optional.empty();
        }
    }
}
