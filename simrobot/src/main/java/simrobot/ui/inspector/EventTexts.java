package simrobot.ui.inspector;

import java.util.Locale;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simrobot.control.LoggedEvent;
import simrobot.drawing.NumberTexts;
import simrobot.process.BehaviourKind;

/** Logged events in words. */
public final class EventTexts {
    private final TextBundle texts;

    public EventTexts(TextBundle texts) {
        this.texts = texts;
    }

    /** The text for the event's name, with the fields after the robot's name. */
    public String of(Event event) {
        String key = "log." + event.name()
                + (event.name().equals("modem") ? "." + event.fields().get("state") : "");
        return texts.of(
                key,
                event.fields().keySet().stream()
                        .filter(field -> !field.equals("robot"))
                        .map(field -> word(event, field))
                        .toArray());
    }

    private String word(Event event, String field) {
        String value = event.fields().get(field);
        return switch (event.name() + " " + field) {
            case "ringing from", "call from" -> value.isEmpty() ? texts.of("order.from.unknown") : value;
            case "order verdict", "battery state" -> texts.of("log." + event.name() + "." + value);
            case "behaviour value" -> RobotsCard.word(texts, BehaviourKind.shown(value));
            case "status value" ->
                texts.of("status." + value.toLowerCase(Locale.ROOT).replace(' ', '_'));
            default -> value;
        };
    }

    /** A line for the clipboard: time, robot and text, separated by tabs. */
    String line(LoggedEvent event) {
        return NumberTexts.clock(event.timeNanos()) + "\t" + event.robot() + "\t" + of(event.line());
    }
}
