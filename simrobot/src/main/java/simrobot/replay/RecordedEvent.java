package simrobot.replay;

import java.util.Optional;
import simgsm.console.Event;
import simgsm.octets.OctetReader;
import simgsm.octets.OctetWriter;

/**
 * An event of a session.
 *
 * @param timeNanos simulated time
 * @param robot the robot's name; empty if the event belongs to none
 * @param name the event's name, the first word of the line
 * @param line the line that the console prints
 */
public record RecordedEvent(long timeNanos, String robot, String name, String line) {
    private static final String COLLISION = "value=Collision";

    static RecordedEvent of(long timeNanos, Event event) {
        return new RecordedEvent(timeNanos, event.fields().getOrDefault("robot", ""), event.name(), event.toString());
    }

    /** The event as a mark on the timeline; empty if the timeline omits it. */
    Optional<TimelineMarker> marker() {
        return kind().map(kind -> new TimelineMarker(timeNanos, kind, robot, line));
    }

    private Optional<TimelineMarker.Kind> kind() {
        return switch (name) {
            case "order" -> Optional.of(TimelineMarker.Kind.ORDER);
            case "outcome" -> Optional.of(TimelineMarker.Kind.REPLY);
            case "call", "released" -> Optional.of(TimelineMarker.Kind.CALL);
            case "status" -> line.endsWith(COLLISION) ? Optional.of(TimelineMarker.Kind.COLLISION) : Optional.empty();
            default -> Optional.empty();
        };
    }

    void write(OctetWriter out) {
        out.eightOctets(timeNanos).text(robot).text(name).text(line);
    }

    static RecordedEvent read(OctetReader<DamagedException> in) {
        return new RecordedEvent(in.eightOctets("a time"), in.text(), in.text(), in.text());
    }
}
