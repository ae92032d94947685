package simgsm.octets;

import java.time.OffsetDateTime;
import java.time.YearMonth;
import java.time.ZoneOffset;

/**
 * TP-SCTS, TP-DT, TP-VP: local time to the second and its zone in quarters of an hour (TS 23.040, 9.2.3.11). The octets
 * are kept, valid or not.
 *
 * <pre>
 *   YY MM DD hh mm ss zz   each with its digits swapped; the sign of zz is bit 4 of its octet
 * </pre>
 */
public record Timestamp(OctetString octets) {
    public static final int LENGTH = 7;

    private static final int WEST = 0x08;
    private static final int QUARTER_SECONDS = 15 * 60;
    /** First two-digit year of the 1900s: 90 to 99 are 1990 to 1999. */
    private static final int FIRST_YEAR = 90;

    public Timestamp {
        octets.requireLength("a time stamp", LENGTH);
    }

    /** The stamp of a time; fractions of seconds are dropped. */
    public static Timestamp of(OffsetDateTime time) {
        OctetWriter out = new OctetWriter();
        out.octet(swapped(time.getYear() % 100)).octet(swapped(time.getMonthValue()));
        out.octet(swapped(time.getDayOfMonth())).octet(swapped(time.getHour()));
        out.octet(swapped(time.getMinute())).octet(swapped(time.getSecond()));
        int quarters = time.getOffset().getTotalSeconds() / QUARTER_SECONDS;
        out.octet(swapped(Math.abs(quarters)) | (quarters < 0 ? WEST : 0));
        return new Timestamp(out.toOctetString());
    }

    /** The stamp of MM INFORMATION (TS 24.008, 10.5.3.9): universal time with the local zone. */
    public static Timestamp ofUniversal(OffsetDateTime time) {
        return of(time.withOffsetSameInstant(ZoneOffset.UTC).withOffsetSameLocal(time.getOffset()));
    }

    /** The local time of such a stamp. */
    public OffsetDateTime fromUniversal() {
        OffsetDateTime stamped = toOffsetDateTime();
        return stamped.withOffsetSameLocal(ZoneOffset.UTC).withOffsetSameInstant(stamped.getOffset());
    }

    /** The time; an invalid digit is read as 0, a field out of range as the nearest valid value. */
    public OffsetDateTime toOffsetDateTime() {
        byte[] fields = octets.toArray();
        int twoDigits = number(fields[0], 0x0f);
        int year = twoDigits + (twoDigits < FIRST_YEAR ? 2000 : 1900);
        int month = within(number(fields[1], 0x0f), 1, 12);
        int day = within(number(fields[2], 0x0f), 1, YearMonth.of(year, month).lengthOfMonth());
        int quarters = number(fields[6], 0x07) * ((fields[6] & WEST) != 0 ? -1 : 1);
        int most = ZoneOffset.MAX.getTotalSeconds() / QUARTER_SECONDS;
        return OffsetDateTime.of(
                year,
                month,
                day,
                within(number(fields[3], 0x0f), 0, 23),
                within(number(fields[4], 0x0f), 0, 59),
                within(number(fields[5], 0x0f), 0, 59),
                0,
                ZoneOffset.ofTotalSeconds(within(quarters, -most, most) * QUARTER_SECONDS));
    }

    private static int swapped(int number) {
        return number % 10 << 4 | number / 10;
    }

    private static int number(byte octet, int tensMask) {
        return 10 * digit(octet & tensMask) + digit(octet >> 4 & 0x0f);
    }

    private static int digit(int nibble) {
        return nibble > 9 ? 0 : nibble;
    }

    private static int within(int value, int least, int most) {
        return Math.max(least, Math.min(most, value));
    }
}
