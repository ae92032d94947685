package simrobot.ui;

import java.util.List;
import simrobot.replay.TimelineMarker;

/**
 * A recording that is played: where it begins and ends, in simulated time, and what is marked in it.
 *
 * @param markers in their order
 */
public record Timeline(long firstNanos, long lastNanos, List<TimelineMarker> markers) {
    public Timeline {
        markers = List.copyOf(markers);
        if (lastNanos < firstNanos) {
            throw new IllegalArgumentException("a recording that ends at " + lastNanos + " ns, before it begins");
        }
    }

    /** Within the recording. */
    public long clamp(long nanos) {
        return Math.max(firstNanos, Math.min(lastNanos, nanos));
    }

    /** The time of the next marker behind a time, or the end. */
    public long next(long nanos) {
        return markers.stream()
                .mapToLong(TimelineMarker::timeNanos)
                .filter(at -> at > nanos)
                .findFirst()
                .orElse(lastNanos);
    }

    /** The time of the marker before a time, or the beginning. */
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
