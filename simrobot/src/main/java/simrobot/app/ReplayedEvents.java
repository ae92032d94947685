package simrobot.app;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simrobot.control.LoggedEvent;
import simrobot.control.RobotEvent;
import simrobot.replay.RecordedEvent;

/** Recorded console lines as events of the window's log. */
final class ReplayedEvents {
    private static final Pattern FIELD = Pattern.compile(" ([a-z0-9]+)=(?:\"((?:[^\"\\\\]|\\\\.)*)\"|([^ ]*))");

    private ReplayedEvents() {}

    /** Empty for events that the log does not keep. */
    static Optional<LoggedEvent> of(RecordedEvent recorded) {
        return RobotEvent.of(recorded.name(), fields(recorded.line()))
                .map(event -> new LoggedEvent(recorded.timeNanos(), recorded.robot(), event));
    }

    private static Map<String, String> fields(String line) {
        Map<String, String> fields = new HashMap<>();
        Matcher matcher = FIELD.matcher(line);
        while (matcher.find()) {
            fields.put(
                    matcher.group(1),
                    matcher.group(2) == null
                            ? matcher.group(3)
                            : matcher.group(2).replaceAll("\\\\(.)", "$1"));
        }
        return fields;
    }
}
