package simrobot.drawing;

import java.util.Locale;

/** Numbers for people: a decimal point in every language, never minus zero. */
public final class NumberTexts {
    private NumberTexts() {}

    /** With three decimals. */
    public static String meters(double value) {
        return fixed(value, 3);
    }

    /** In [0, 360), anticlockwise from +X. */
    public static String degrees(double radians) {
        double turned = Math.rint(Math.toDegrees(radians) * 10) / 10 % 360;
        return fixed(turned < 0 ? turned + 360 : turned, 1);
    }

    /** Simulated time as h:mm:ss.cc. */
    public static String clock(long nanos) {
        long centis = nanos / 10_000_000;
        return String.format(
                Locale.ROOT,
                "%d:%02d:%02d.%02d",
                centis / 360_000,
                centis / 6000 % 60,
                centis / 100 % 60,
                centis % 100);
    }

    public static String fixed(double value, int decimals) {
        double scale = Math.pow(10, decimals);
        return String.format(Locale.ROOT, "%." + decimals + "f", Math.rint(value * scale) / scale + 0.0);
    }
}
