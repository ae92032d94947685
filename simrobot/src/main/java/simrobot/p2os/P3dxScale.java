package simrobot.p2os;

/** Units of a p3dx, from ARIA's p3dx.p, which a client loads by the type sent in the handshake. */
final class P3dxScale {
    static final String CLASS = "Pioneer";
    static final String SUBCLASS = "p3dx";

    /** Unit of position, DistConvFactor. */
    static final double MILLIMETERS_PER_UNIT = 0.485;

    /** Unit of angles, AngleConvFactor 0.001534: 4096 units per turn. */
    static final int UNITS_PER_TURN = 4096;

    /** Unit of wheel speed in the two-wheel command, Vel2Divisor. */
    static final double WHEEL_UNIT_MILLIMETERS_PER_SECOND = 20;

    /** MaxVelocity, the top speed. */
    static final int MOST_MILLIMETERS_PER_SECOND = 2200;

    /** MaxRVelocity, the top turning speed. */
    static final int MOST_DEGREES_PER_SECOND = 500;

    /** The greatest acceleration accepted, mm/s2: the maximum of a signed 16-bit argument. */
    static final int MOST_ACCELERATION = 0x7FFF;

    /** Encoder ticks per millimetre, as in the configuration packet. */
    static final int TICKS_PER_MILLIMETER = 128;

    private static final int PLACE_MASK = 0x7FFF;

    private P3dxScale() {}

    /** Returns the position in units: 15 bits, unsigned, wrapping. */
    static int place(double meters) {
        return (int) (Math.round(meters * 1000 / MILLIMETERS_PER_UNIT) & PLACE_MASK);
    }

    /** Returns the angle in units, -2048 to 2047. */
    static int angle(double radians) {
        int units = (int) Math.floorMod(Math.round(radians / (2 * Math.PI) * UNITS_PER_TURN), (long) UNITS_PER_TURN);
        return units >= UNITS_PER_TURN / 2 ? units - UNITS_PER_TURN : units;
    }

    static int millimeters(double meters) {
        return (int) Math.round(meters * 1000);
    }

    /** Returns the wheels' encoder ticks; they wrap after about 16 km. */
    static int ticks(double meters) {
        return (int) Math.round(meters * 1000 * TICKS_PER_MILLIMETER);
    }
}
