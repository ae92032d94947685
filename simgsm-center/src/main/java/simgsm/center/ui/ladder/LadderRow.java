package simgsm.center.ui.ladder;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import simgsm.air.Direction;
import simgsm.center.msc.LadderEntry;

/**
 * A message with its number.
 *
 * @param number counts messages from 1; never used twice
 */
record LadderRow(long number, LadderEntry entry) {
    private static final DateTimeFormatter CLOCK =
            DateTimeFormatter.ofPattern("HH:mm:ss.SSS").withZone(ZoneId.systemDefault());

    Direction direction() {
        return entry.from().equals(LadderEntry.CENTER) ? Direction.DOWNLINK : Direction.UPLINK;
    }

    /** The lifeline other than the centre's. */
    String terminal() {
        return direction() == Direction.DOWNLINK ? entry.to() : entry.from();
    }

    String clock() {
        return CLOCK.format(entry.time());
    }

    /** Used by assistive technology. */
    @Override
    public String toString() {
        return clock() + " " + entry.from() + " → " + entry.to() + " " + entry.name();
    }
}
