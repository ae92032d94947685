package simrobot.app;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simrobot.behaviour.BehaviourKind;
import simrobot.control.LoggedEvent;
import simrobot.replay.RecordedEvent;
import vericommand.RobotStatus;

/** Recorded console lines as the window's log has events. */
final class ReplayedEvents {
    private static final Pattern FIELD = Pattern.compile(" ([a-z0-9]+)=(?:\"((?:[^\"\\\\]|\\\\.)*)\"|([^ ]*))");

    private ReplayedEvents() {}

    /** Empty for what the log does not hold: keys, poses, tones. */
    static Optional<LoggedEvent> of(RecordedEvent event) {
        Map<String, String> fields = fields(event.line());
        try {
            return switch (event.name()) {
                case "added" -> logged(event, LoggedEvent.Kind.ADDED, fields.get("number"), "");
                case "removed" -> logged(event, LoggedEvent.Kind.REMOVED, "", "");
                case "registered" -> logged(event, LoggedEvent.Kind.REGISTERED, fields.get("number"), "");
                case "unregistered" -> logged(event, LoggedEvent.Kind.UNREGISTERED, fields.get("cause"), "");
                case "call" -> logged(event, LoggedEvent.Kind.CALL, fields.get("from"), "");
                case "order" -> logged(event, LoggedEvent.Kind.ORDER, fields.get("text"), fields.get("verdict"));
                case "outcome" -> logged(event, LoggedEvent.Kind.OUTCOME, fields.get("tone"), fields.get("text"));
                case "reply" -> logged(event, LoggedEvent.Kind.REPLY, fields.get("to"), fields.get("text"));
                case "sms" -> logged(event, LoggedEvent.Kind.MESSAGE, fields.get("from"), fields.get("text"));
                case "released" -> logged(event, LoggedEvent.Kind.RELEASED, fields.get("cause"), "");
                case "status" ->
                    logged(
                            event,
                            LoggedEvent.Kind.STATUS,
                            RobotStatus.ofText(fields.get("value")).name(),
                            "");
                case "behaviour" ->
                    logged(
                            event,
                            LoggedEvent.Kind.BEHAVIOUR,
                            BehaviourKind.ofText(fields.get("value")).name(),
                            "");
                default -> Optional.empty();
            };
        } catch (IllegalArgumentException ofALaterVersion) {
            return Optional.empty();
        }
    }

    private static Optional<LoggedEvent> logged(RecordedEvent event, LoggedEvent.Kind kind, String what, String text) {
        return Optional.of(new LoggedEvent(
                event.timeNanos(), event.robot(), kind, what == null ? "" : what, text == null ? "" : text));
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
