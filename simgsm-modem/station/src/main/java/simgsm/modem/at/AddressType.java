package simgsm.modem.at;

/** Type of address, before or after the numbers on an AT line (TS 24.008, 10.5.4.7). */
public final class AddressType {
    public static final int INTERNATIONAL = 145;
    public static final int UNKNOWN = 129;

    private AddressType() {}

    public static int of(String number) {
        return number.startsWith("+") ? INTERNATIONAL : UNKNOWN;
    }
}
