package simrobot.p2os;

/** What a p3dx's numbers mean: ARIA's p3dx.p, which a client loads because of the name that the handshake tells it. */
final class P3dxScale {
    static final String CLASS = "Pioneer";
    static final String SUBCLASS = "p3dx";

    /** A place's unit, DistConvFactor. */
    static final double MILLIMETERS_PER_UNIT = 0.485;

    /** An angle's unit, AngleConvFactor 0.001534: 4096 to the turn. */
    static final int UNITS_PER_TURN = 4096;

    /** A wheel speed's unit in the two-wheel command, Vel2Divisor. */
    static final double WHEEL_UNIT_MILLIMETERS_PER_SECOND = 20;

    /** MaxVelocity, nothing goes faster. */
    static final int MOST_MILLIMETERS_PER_SECOND = 2200;

    /** MaxRVelocity. */
    static final int MOST_DEGREES_PER_SECOND = 500;

    /** No acceleration above this is taken: 32 m/s2, what two bytes hold. */
    static final int MOST_ACCELERATION = 0x7FFF;

    /** Encoder ticks a millimetre, as the configuration packet tells. */
    static final int TICKS_PER_MILLIMETER = 128;

    private static final int PLACE_MASK = 0x7FFF;

    private P3dxScale() {}

    /** 15 bits, never negative; it rolls over. */
    static int place(double meters) {
        return (int) (Math.round(meters * 1000 / MILLIMETERS_PER_UNIT) & PLACE_MASK);
    }

    /** -2048 to 2047. */
    static int angle(double radians) {
        int units = (int) Math.floorMod(Math.round(radians / (2 * Math.PI) * UNITS_PER_TURN), (long) UNITS_PER_TURN);
        return units >= UNITS_PER_TURN / 2 ? units - UNITS_PER_TURN : units;
    }

    static int millimeters(double meters) {
        return (int) Math.round(meters * 1000);
    }

    /** The wheels' ticks; they roll over after some 16 km. */
    static int ticks(double meters) {
        return (int) Math.round(meters * 1000 * TICKS_PER_MILLIMETER);
    }
}
