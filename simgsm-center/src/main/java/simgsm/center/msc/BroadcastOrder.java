package simgsm.center.msc;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * An order for a cell broadcast.
 *
 * @param channel message identifier, 0 to 65535
 * @param language two letters of ISO 639, if given
 * @param period between two repetitions, 1 s to 24 h; unused for a single broadcast
 * @param times 1 to 65535; empty: until it is stopped
 * @param updated id of the repeated broadcast that this one replaces
 */
public record BroadcastOrder(
        int channel, String text, Optional<String> language, Duration period, OptionalInt times, OptionalInt updated) {
    public static final Duration DEFAULT_PERIOD = Duration.ofSeconds(30);
    public static final Duration LONGEST_PERIOD = Duration.ofHours(24);
    public static final int MOST_TIMES = 65_535;

    private static final int MAX_CHANNEL = 0xffff;

    public BroadcastOrder {
        if (channel < 0 || channel > MAX_CHANNEL) {
            throw new IllegalArgumentException("broadcast channel " + channel + " is not 0 to 65535");
        }
        if (period.compareTo(Duration.ofSeconds(1)) < 0 || period.compareTo(LONGEST_PERIOD) > 0) {
            throw new IllegalArgumentException("a period of " + period.toSeconds() + " s is not 1 to 86400 s");
        }
        if (times.isPresent() && (times.getAsInt() < 1 || times.getAsInt() > MOST_TIMES)) {
            throw new IllegalArgumentException(times.getAsInt() + " times is not 1 to " + MOST_TIMES);
        }
    }

    /** A single broadcast without language. */
    public static BroadcastOrder once(int channel, String text) {
        return new BroadcastOrder(
                channel, text, Optional.empty(), DEFAULT_PERIOD, OptionalInt.of(1), OptionalInt.empty());
    }
}
