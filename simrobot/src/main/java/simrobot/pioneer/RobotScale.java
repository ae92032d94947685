package simrobot.pioneer;

import java.util.Locale;
import java.util.Map;

/**
 * Conversion factors of a robot type, from ARIA's params files.
 *
 * @param millimetersPerUnit unit of position, DistConvFactor
 * @param millimetersPerRangeUnit unit of a sonar's range, RangeConvFactor
 */
record RobotScale(double millimetersPerUnit, double millimetersPerRangeUnit) {
    /** AngleConvFactor 0.001534: 4096 units per turn. */
    static final int UNITS_PER_TURN = 4096;

    /** P2-DX and similar types. */
    private static final RobotScale P2DX = new RobotScale(0.84, 0.268);

    /** P3-DX and later types. */
    private static final RobotScale P3DX = new RobotScale(0.485, 1.0);

    private static final Map<String, RobotScale> KNOWN = Map.of(
            "p2dx",
            P2DX,
            "p2at",
            new RobotScale(1.32, 0.268),
            "p2de",
            new RobotScale(0.969, 0.268),
            "p2ce",
            P2DX,
            "p2d8",
            P3DX,
            "p2at8",
            P3DX,
            "p3dx",
            P3DX,
            "p3at",
            P3DX,
            "p3dx-sh",
            P3DX,
            "p3at-sh",
            P3DX);

    static boolean isKnown(String subclass) {
        return KNOWN.containsKey(subclass.toLowerCase(Locale.ROOT));
    }

    /** Returns the factors of this type; those of the P3-DX, which nearly all later types share, if it is unknown. */
    static RobotScale of(String subclass) {
        return KNOWN.getOrDefault(subclass.toLowerCase(Locale.ROOT), P3DX);
    }
}
