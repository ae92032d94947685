package simgsm.air;

/**
 * An equipment with its software version (TS 23.003, 6.2.2): the IMEI without its check digit, and two digits of the version.
 *
 * @param digits 16 decimal digits
 */
public record Imeisv(String digits) implements MobileIdentity {
    /** The version of the suite's terminals. */
    private static final String VERSION = "01";

    public Imeisv {
        if (!digits.matches("[0-9]{16}")) {
            throw new IllegalArgumentException("IMEISV \"" + digits + "\" is not 16 digits");
        }
    }

    /** The identity of a terminal of the suite. */
    public static Imeisv of(Imei imei) {
        return new Imeisv(imei.digits().substring(0, 14) + VERSION);
    }

    @Override
    public Type type() {
        return Type.IMEISV;
    }

    @Override
    public String toString() {
        return digits;
    }
}
