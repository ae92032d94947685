package simgsm.center.msc;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A broadcast that is repeated.
 *
 * @param id to stop or update it by
 * @param update number of the text's latest change, 0 to 15
 * @param sent how often so far
 * @param left how often still; empty for until it is stopped
 */
public record BroadcastView(
        int id,
        int channel,
        Optional<String> language,
        int update,
        int pages,
        Duration period,
        int sent,
        OptionalInt left,
        String text) {}
