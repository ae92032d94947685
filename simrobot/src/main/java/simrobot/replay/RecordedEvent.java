package simrobot.replay;

import java.util.Optional;
import simgsm.console.Event;
import simgsm.octets.OctetReader;
import simgsm.octets.OctetWriter;

/**
 * An event of a session.
 *
 * @param timeNanos simulated time
 * @param robot whose it is; empty for nobody's
 * @param name its first word
 * @param line the whole of it as the console had it
 */
public record RecordedEvent(long timeNanos, String robot, String name, String line) {
    private static final String COLLISION = "value=Collision";

    static RecordedEvent of(long timeNanos, Event event) {
        return new RecordedEvent(timeNanos, event.fields().getOrDefault("robot", ""), event.name(), event.toString());
    }

    /** What a timeline shows of it, if anything. */
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

    void write(OctetWriter out, long previousNanos) {
        out.compactSigned(timeNanos - previousNanos).text(robot).text(name).text(line);
    }

    static RecordedEvent read(OctetReader<DamagedException> in, long previousNanos) {
        return new RecordedEvent(previousNanos + in.compactSigned(), in.text(), in.text(), in.text());
    }
}
