package simrobot.ui;

import java.util.Locale;

/** Numbers of the pose as people read them: a dot for the decimal in every language, and never minus zero. */
public final class PoseTexts {
    private PoseTexts() {}

    public static String meters(double value) {
        return fixed(value, 3);
    }

    /** In [0, 360), anticlockwise from +X. */
    public static String degrees(double radians) {
        double turned = Math.rint(Math.toDegrees(radians) * 10) / 10 % 360;
        return fixed(turned < 0 ? turned + 360 : turned, 1);
    }

    public static String fixed(double value, int decimals) {
        double scale = Math.pow(10, decimals);
        return String.format(Locale.ROOT, "%." + decimals + "f", Math.rint(value * scale) / scale + 0.0);
    }
}
