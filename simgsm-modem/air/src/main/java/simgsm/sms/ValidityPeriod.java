package simgsm.sms;

import java.time.Duration;
import java.time.Instant;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;

/** TP-VP: the time for which the centre attempts delivery (TS 23.040, 9.2.3.12). */
public sealed interface ValidityPeriod {
    /** The end of the period of a message accepted by the centre at this time. */
    Instant expiry(Instant accepted);

    /** @param octet 0 to 255: steps of 5 min to 12 h, 30 min to 24 h, days to 30, weeks to 63 */
    record Relative(int octet) implements ValidityPeriod {
        public static final Relative ONE_DAY = new Relative(167);
        public static final Relative LONGEST = new Relative(255);

        public Relative {
            Bounds.checkOctet("validity period", octet);
        }

        public Duration duration() {
            if (octet <= 143) {
                return Duration.ofMinutes((octet + 1) * 5L);
            }
            if (octet <= 167) {
                return Duration.ofHours(12).plusMinutes((octet - 143) * 30L);
            }
            return Duration.ofDays(octet <= 196 ? octet - 166 : (octet - 192) * 7L);
        }

        @Override
        public Instant expiry(Instant accepted) {
            return accepted.plus(duration());
        }
    }

    record Absolute(Timestamp time) implements ValidityPeriod {
        @Override
        public Instant expiry(Instant accepted) {
            return time.toOffsetDateTime().toInstant();
        }
    }

    /** The third form, seven octets; the first gives the format of the others. */
    record Enhanced(OctetString octets) implements ValidityPeriod {
        private static final int RELATIVE = 1;
        private static final int SECONDS = 2;
        private static final int HOURS_MINUTES_SECONDS = 3;

        public Enhanced {
            octets.requireLength("an enhanced validity period", Timestamp.LENGTH);
        }

        /** An extension or a reserved format is read as the longest period. */
        @Override
        public Instant expiry(Instant accepted) {
            byte[] fields = octets.toArray();
            boolean extended = (fields[0] & 0x80) != 0;
            return switch (extended ? 0 : fields[0] & 0x07) {
                case RELATIVE -> new Relative(fields[1] & 0xff).expiry(accepted);
                case SECONDS -> accepted.plusSeconds(fields[1] & 0xff);
                case HOURS_MINUTES_SECONDS ->
                    accepted.plusSeconds(3600L * swapped(fields[1]) + 60L * swapped(fields[2]) + swapped(fields[3]));
                default -> Relative.LONGEST.expiry(accepted);
            };
        }

        private static int swapped(byte octet) {
            return 10 * Math.min(9, octet & 0x0f) + Math.min(9, octet >> 4 & 0x0f);
        }
    }
}
