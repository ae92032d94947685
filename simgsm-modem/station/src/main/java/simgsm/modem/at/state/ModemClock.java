package simgsm.modem.at.state;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.InstantSource;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The modem's clock (AT+CCLK): the machine's local time until a client sets it. */
public final class ModemClock {
    private static final Pattern STAMP =
            Pattern.compile("(\\d\\d)/(\\d\\d)/(\\d\\d),(\\d\\d):(\\d\\d):(\\d\\d)(?:([+-])(\\d\\d))?");
    private static final int QUARTER_SECONDS = 15 * 60;

    private final InstantSource wallClock;
    private Duration ahead = Duration.ZERO;
    private ZoneOffset zone;

    public ModemClock(InstantSource wallClock) {
        this.wallClock = wallClock;
        zone = ZoneId.systemDefault().getRules().getOffset(wallClock.instant());
    }

    public OffsetDateTime now() {
        return wallClock.instant().plus(ahead).atOffset(zone);
    }

    /** Sets time and zone. */
    public void set(OffsetDateTime time) {
        zone = time.getOffset();
        ahead = Duration.between(wallClock.instant(), time);
    }

    /** IllegalArgumentException for anything but {@code yy/MM/dd,hh:mm:ss} with or without quarters of an hour. */
    public void set(String text) {
        Matcher stamp = STAMP.matcher(text);
        if (!stamp.matches()) {
            throw new IllegalArgumentException("expected yy/MM/dd,hh:mm:ss, found " + text);
        }
        try {
            ZoneOffset newZone = stamp.group(7) == null
                    ? zone
                    : ZoneOffset.ofTotalSeconds(Integer.parseInt(stamp.group(7) + stamp.group(8)) * QUARTER_SECONDS);
            OffsetDateTime time = OffsetDateTime.of(
                    2000 + number(stamp, 1),
                    number(stamp, 2),
                    number(stamp, 3),
                    number(stamp, 4),
                    number(stamp, 5),
                    number(stamp, 6),
                    0,
                    newZone);
            set(time);
        } catch (DateTimeException impossible) {
            throw new IllegalArgumentException(impossible.getMessage(), impossible);
        }
    }

    private static int number(Matcher stamp, int group) {
        return Integer.parseInt(stamp.group(group));
    }

    /** {@code yy/MM/dd,hh:mm:ss+zz}, zz in quarters of an hour (TS 27.007, 8.15; TS 27.005, 3.1). */
    public static String format(OffsetDateTime time) {
        int quarters = time.getOffset().getTotalSeconds() / QUARTER_SECONDS;
        return String.format(
                Locale.ROOT,
                "%02d/%02d/%02d,%02d:%02d:%02d%s%02d",
                time.getYear() % 100,
                time.getMonthValue(),
                time.getDayOfMonth(),
                time.getHour(),
                time.getMinute(),
                time.getSecond(),
                quarters < 0 ? "-" : "+",
                Math.abs(quarters));
    }
}
