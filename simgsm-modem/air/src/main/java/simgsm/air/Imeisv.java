package simgsm.air;

/** An equipment with two digits of its software version (TS 23.003, 6.2.2). @param digits 14 of the IMEI, 2 of the version */
public record Imeisv(String digits) implements MobileIdentity {
    public Imeisv {
        if (!digits.matches("[0-9]{16}")) {
            throw new IllegalArgumentException("IMEISV \"" + digits + "\" is not 16 digits");
        }
    }

    /** The identity of a terminal of the suite, version 01. */
    public static Imeisv of(Imei imei) {
        return new Imeisv(imei.digits().substring(0, 14) + "01");
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
