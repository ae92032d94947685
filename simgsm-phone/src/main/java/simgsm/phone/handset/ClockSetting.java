package simgsm.phone.handset;

import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.Optional;

/**
 * How the phone's clock differs from the machine's: set by the network's time (TS 24.008, 9.2.15a).
 *
 * @param ahead of the machine's clock
 * @param zone the network's; empty for the machine's
 */
public record ClockSetting(Duration ahead, Optional<ZoneId> zone) {
    /** The machine's clock. */
    static final ClockSetting NONE = new ClockSetting(Duration.ZERO, Optional.empty());

    static ClockSetting of(OffsetDateTime network, Instant machine) {
        return new ClockSetting(Duration.between(machine, network), Optional.of(network.getOffset()));
    }

    /** The time on the phone's display. */
    public ZonedDateTime at(ZonedDateTime machine) {
        ZonedDateTime time = machine.plus(ahead);
        return zone.map(time::withZoneSameInstant).orElse(time);
    }
}
