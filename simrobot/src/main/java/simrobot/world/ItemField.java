package simrobot.world;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.function.Function;

/**
 * A field of a kind of item, used by reader, form and print-out.
 *
 * @param key part of the key of its texts
 * @param value a String for {@link Unit#TEXT}, else a Double in metres, radians, metres per second or a share
 * @param isTyped true if the editor's form shows it
 */
public record ItemField<T extends WorldItem>(String key, Unit unit, Function<T, Object> value, boolean isTyped) {
    /** Units with the largest value that a form accepts, and the factor from SI to the print-out. */
    public enum Unit {
        TEXT(0, 1),
        METERS(100_000, 1000),
        DEGREES(360, 1),
        METERS_PER_SECOND(10, 1000),
        SHARE(1, 1);

        private final double most;
        private final double printed;

        Unit(double most, double printed) {
            this.most = most;
            this.printed = printed;
        }

        /** The largest value in the unit of the form: metres, degrees. */
        public double most() {
            return most;
        }
    }

    /** The value in the unit of files: millimetres, degrees; rounded against the error of the conversion to SI and back. */
    public String printed(T item) {
        if (unit == Unit.TEXT) {
            return (String) value.apply(item);
        }
        double number = unit == Unit.DEGREES ? Math.toDegrees(number(item)) : number(item) * unit.printed;
        return plain(BigDecimal.valueOf(number).setScale(4, RoundingMode.HALF_EVEN));
    }

    /** The value in the unit of the form: metres, degrees in [0, 360). */
    public String typed(T item) {
        if (unit == Unit.TEXT) {
            return (String) value.apply(item);
        }
        double number = number(item);
        if (unit == Unit.DEGREES) {
            double degrees = Math.rint(Math.toDegrees(number) * 1e6) / 1e6 % 360;
            number = degrees < 0 ? degrees + 360 : degrees;
        }
        return plain(BigDecimal.valueOf(number));
    }

    /** The number, SI. */
    public double number(T item) {
        return (Double) value.apply(item);
    }

    /** Converts a number of the form to SI. */
    public double fromTyped(double number) {
        return unit == Unit.DEGREES ? Math.toRadians(number) : number;
    }

    /** Formats without trailing zeros and exponent. */
    static String plain(BigDecimal number) {
        return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
    }
}
