package simrobot.ui;

import java.util.List;
import simrobot.replay.TimelineMarker;

/**
 * Beginning and end of a recording, in simulated time, and its markers.
 *
 * @param markers in order
 */
public record Timeline(long firstNanos, long lastNanos, List<TimelineMarker> markers) {
    public Timeline {
        markers = List.copyOf(markers);
        if (lastNanos < firstNanos) {
            throw new IllegalArgumentException("a recording that ends at " + lastNanos + " ns, before it begins");
        }
    }

    /** The time limited to the recording. */
    public long clamp(long nanos) {
        return Math.max(firstNanos, Math.min(lastNanos, nanos));
    }

    /** The time of the first marker after a time, or the end. */
    public long next(long nanos) {
        return markers.stream()
                .mapToLong(TimelineMarker::timeNanos)
                .filter(at -> at > nanos)
                .findFirst()
                .orElse(lastNanos);
    }

    /** The time of the last marker before a time, or the beginning. */
    public long previous(long nanos) {
        long before = firstNanos;
        for (TimelineMarker marker : markers) {
            if (marker.timeNanos() < nanos) {
                before = Math.max(before, marker.timeNanos());
            }
        }
        return before;
    }
}
