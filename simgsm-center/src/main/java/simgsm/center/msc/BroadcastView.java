package simgsm.center.msc;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.event.EventLine;

/**
 * A repeated cell broadcast.
 *
 * <p>As a line: answer to {@code broadcasts}.
 *
 * @param id for stopping and updating
 * @param update update number of the text, 0 to 15
 * @param sent number of broadcasts so far
 * @param left number of further broadcasts; empty: until it is stopped
 */
@EventLine("broadcast id= channel= language= update= pages= every=period.toSeconds sent= [left=] text=")
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
