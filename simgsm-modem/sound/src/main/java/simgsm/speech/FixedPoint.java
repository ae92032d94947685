package simgsm.speech;

/** The 16-bit fixed-point operations of GSM 06.10 (ETS 300 961, 5.1), with its saturation and rounding. */
final class FixedPoint {
    static final int MOST = Short.MAX_VALUE;
    static final int LEAST = Short.MIN_VALUE;

    private FixedPoint() {}

    static int saturate(int value) {
        return value > MOST ? MOST : Math.max(value, LEAST);
    }

    static int add(int a, int b) {
        return saturate(a + b);
    }

    static int subtract(int a, int b) {
        return saturate(a - b);
    }

    static int absolute(int a) {
        return a == LEAST ? MOST : Math.abs(a);
    }

    /** Product of two fractions of 15 bits, truncated. */
    static int multiply(int a, int b) {
        return a == LEAST && b == LEAST ? MOST : a * b >> 15;
    }

    /** Product of two fractions of 15 bits, rounded. */
    static int multiplyRounded(int a, int b) {
        return a == LEAST && b == LEAST ? MOST : a * b + 16384 >> 15;
    }

    /** The left shift of a positive 32-bit number that leaves the sign bit 0. */
    static int headroom(int a) {
        return Integer.numberOfLeadingZeros(a) - 1;
    }

    /** The fraction {@code numerator / denominator} in 15 bits, truncated; 0 to 1. */
    static int divide(int numerator, int denominator) {
        int quotient = 0;
        int rest = numerator;
        for (int i = 0; i < 15; i++) {
            quotient <<= 1;
            rest <<= 1;
            if (rest >= denominator) {
                rest -= denominator;
                quotient++;
            }
        }
        return quotient;
    }
}
