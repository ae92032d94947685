package simrobot.pioneer;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The units and the top speeds of a type of robot, the "subclass" of its handshake, by ARIA's params files.
 *
 * @param millimetersPerUnit unit of position, DistConvFactor
 * @param millimetersPerRangeUnit unit of a sonar's range, RangeConvFactor
 * @param unitsPerTurn full circle over AngleConvFactor, to the power of two at which the heading wraps
 * @param wheelSpeedFactor mm/s per unit of the reported wheel speeds, VelConvFactor
 * @param topMillimetersPerSecond MaxVelocity
 * @param topDegreesPerSecond MaxRVelocity
 */
public record RobotKind(
        double millimetersPerUnit,
        double millimetersPerRangeUnit,
        int unitsPerTurn,
        double wheelSpeedFactor,
        int topMillimetersPerSecond,
        int topDegreesPerSecond) {
    private static final int P2OS_UNITS_PER_TURN = 4096;

    /** AngleConvFactor 0.00614 of the first Pioneers. */
    private static final int PSOS_UNITS_PER_TURN = 1024;

    private static final Map<String, RobotKind> KNOWN = new HashMap<>();

    static {
        know(0.84, 0.268, "p2dx");
        know(0.969, 0.268, "p2de");
        know(0.826, 0.268, "p2ce");
        know(0.485, 0.268, "p2df", "p2pp");
        know(0.424, 0.268, "p2pb");
        know(1.32, 0.268, "p2at");
        know(1.136, 0.268, "p2it");
        know(1.32, 1, "p2at8");
        know(0.465, 1, "p2at8+", "p3at");
        know(0.485, 1, "p2d8", "p2d8+", "p3dx", "perfpb", "perfpb+");
        know(0.5813, 1, "powerbot");
        know(1, 1, "p3dx-sh", "p3dx-sh-lms1xx", "p3dx-sh-lms500", "p3at-sh", "p3at-sh-lms1xx", "p3at-sh-lms500");
        know(1, 1, "p3atiw-sh", "peoplebot-sh", "peoplebot-sh-lms1xx", "peoplebot-sh-lms500", "patrolbot-sh");
        know(1, 1, "powerbot-sh", "powerbot-sh-lms500", "powerbot-sh-uarcs", "amigo-sh", "amigo-sh-tim3xx");
        know(1, 1, "researchpb", "researchpb-lms500", "wheelchair-sh", "mt400", "pioneer-lx", "pioneer-lx-ld");
        know(1, 1, "seekur");
        know(new RobotKind(1, 1, P2OS_UNITS_PER_TURN, 1, 1200, 80), "seekurjr");
        know(new RobotKind(0.5083, 1, P2OS_UNITS_PER_TURN, 0.6154, 1000, 300), "amigo");
        know(
                new RobotKind(0.05066, 0.1734, PSOS_UNITS_PER_TURN, 2.5332, 400, 100),
                "pion1m",
                "pion1x",
                "psos1m",
                "psos1x",
                "psos43m");
        know(new RobotKind(0.07, 0.1734, PSOS_UNITS_PER_TURN, 2.5332, 500, 100), "pionat");
    }

    /** Adds kinds with P2OS's usual units of angle and speed; their top speeds exceed the used ones. */
    private static void know(double millimetersPerUnit, double millimetersPerRangeUnit, String... names) {
        know(new RobotKind(millimetersPerUnit, millimetersPerRangeUnit, P2OS_UNITS_PER_TURN, 1, 1000, 180), names);
    }

    private static void know(RobotKind kind, String... names) {
        List.of(names).forEach(name -> KNOWN.put(name, kind));
    }

    /** Returns the kind of this name, ignoring case; empty if it is unknown, and then nothing may move. */
    static Optional<RobotKind> named(String name) {
        return Optional.ofNullable(KNOWN.get(name.toLowerCase(Locale.ROOT)));
    }

    /** Returns the names of all known kinds, in lower case. */
    static Collection<String> names() {
        return KNOWN.keySet();
    }
}
