package simgsm.cells.snapshot;

import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The controller's rule of handovers, set for the window, because controllers do not report it.
 *
 * @param marginDecibels advantage of a neighbour's average over the serving level
 * @param periodReports reports between two decisions
 * @param averagedReports reports in the average of a neighbour's level, 1 to 10
 */
public record HandoverRule(int marginDecibels, int periodReports, int averagedReports) {
    /** Algorithm 1 of osmo-bsc with its defaults. */
    public static final HandoverRule STANDARD = new HandoverRule(3, 6, 10);

    private static final int MOST_AVERAGED = 10;
    private static final int STRONGEST_CELL_MARGIN_DECIBELS = 6;
    private static final Pattern NUMBER = Pattern.compile(",([a-z]+)=([0-9]{1,4})");
    private static final Pattern TEXT =
            Pattern.compile("power-budget(,(levels|neighbours|interval|hysteresis|distance)=[0-9]{1,4})*"
                    + "|strongest-cell(,(margin|reports)=[0-9]{1,4})*");

    /**
     * Parses the value of the centre's {@code --handover}.
     *
     * @throws IllegalArgumentException naming the expected text
     */
    public static HandoverRule parse(String text) {
        if (!TEXT.matcher(text).matches()) {
            throw new IllegalArgumentException("expected power-budget[,hysteresis=DB][,interval=N][,neighbours=N]"
                    + " or strongest-cell[,margin=DB][,reports=N], found " + text);
        }
        Map<String, Integer> numbers = new HashMap<>();
        Matcher matcher = NUMBER.matcher(text);
        while (matcher.find()) {
            numbers.put(matcher.group(1), Integer.valueOf(matcher.group(2)));
        }
        if (text.startsWith("strongest-cell")) {
            return new HandoverRule(numbers.getOrDefault("margin", STRONGEST_CELL_MARGIN_DECIBELS), 1, 1);
        }
        return new HandoverRule(
                numbers.getOrDefault("hysteresis", STANDARD.marginDecibels),
                Math.max(1, numbers.getOrDefault("interval", STANDARD.periodReports)),
                Math.max(1, Math.min(MOST_AVERAGED, numbers.getOrDefault("neighbours", STANDARD.averagedReports))));
    }
}
