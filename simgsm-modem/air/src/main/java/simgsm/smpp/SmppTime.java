package simgsm.smpp;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;

/**
 * Times (7.1.1): {@code YYMMDDhhmmsstnnp}, t tenths of a second, nn quarters of an hour from UTC, p {@code +}, {@code -},
 * or {@code R} for a time relative to now.
 */
public final class SmppTime {
    private static final int LENGTH = 16;
    private static final int QUARTER_SECONDS = 15 * 60;
    private static final int MAX_QUARTERS = 48;
    private static final DateTimeFormatter SECONDS = DateTimeFormatter.ofPattern("yyMMddHHmmss");
    private static final DateTimeFormatter MINUTES = DateTimeFormatter.ofPattern("yyMMddHHmm");

    private SmppTime() {}

    /** @throws IllegalArgumentException if the text is not a valid time */
    public static Instant parse(String text, Instant now) {
        if (text.length() != LENGTH || !text.substring(0, LENGTH - 1).chars().allMatch(c -> c >= '0' && c <= '9')) {
            throw new IllegalArgumentException("\"" + text + "\" is no time of 16 characters");
        }
        int[] fields = new int[6];
        for (int i = 0; i < fields.length; i++) {
            fields[i] = Integer.parseInt(text.substring(2 * i, 2 * i + 2));
        }
        char sign = text.charAt(LENGTH - 1);
        try {
            return switch (sign) {
                case 'R' -> relative(fields, now);
                case '+', '-' -> absolute(fields, Integer.parseInt(text.substring(13, 15)) * (sign == '+' ? 1 : -1));
                default -> throw new IllegalArgumentException("\"" + text + "\" does not end with +, - or R");
            };
        } catch (DateTimeException e) {
            throw new IllegalArgumentException("\"" + text + "\" is no time: " + e.getMessage());
        }
    }

    private static Instant relative(int[] fields, Instant now) {
        return now.atOffset(ZoneOffset.UTC)
                .plusYears(fields[0])
                .plusMonths(fields[1])
                .plusDays(fields[2])
                .plusHours(fields[3])
                .plusMinutes(fields[4])
                .plusSeconds(fields[5])
                .toInstant();
    }

    private static Instant absolute(int[] fields, int quarters) {
        if (Math.abs(quarters) > MAX_QUARTERS) {
            throw new IllegalArgumentException(quarters + " quarters of an hour are no time zone");
        }
        ZoneOffset zone = ZoneOffset.ofTotalSeconds(quarters * QUARTER_SECONDS);
        LocalDateTime local = LocalDateTime.of(2000 + fields[0], fields[1], fields[2], fields[3], fields[4], fields[5]);
        return OffsetDateTime.of(local, zone).toInstant();
    }

    /** The 16 characters, in UTC. */
    public static String full(Instant time) {
        return SECONDS.format(time.atOffset(ZoneOffset.UTC)) + "000+";
    }

    /** YYMMDDhhmm in UTC, for receipts (appendix B). */
    public static String minutes(Instant time) {
        return MINUTES.format(time.atOffset(ZoneOffset.UTC));
    }
}
