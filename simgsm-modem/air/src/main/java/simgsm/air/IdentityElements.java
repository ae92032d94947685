package simgsm.air;

import simgsm.octets.OctetWriter;

/** Mobile identity and location area in messages (TS 24.008, 10.5.1.3 and 10.5.1.4). */
public final class IdentityElements {
    /** In the first octet of an identity: an odd number of digits. */
    private static final int ODD = 0x08;

    private static final int TMSI_FIRST_OCTET = 0xf4;
    /** Longest identity: 16 digits of an IMEISV. */
    private static final int MAX_LENGTH = 9;

    private IdentityElements() {}

    /** Writes an identity's value. */
    public static void write(OctetWriter out, MobileIdentity identity) {
        if (identity instanceof Tmsi tmsi) {
            out.octet(TMSI_FIRST_OCTET).fourOctets(tmsi.value());
        } else {
            String digits = identity instanceof Imei imei ? Imei.transmitted(imei.digits()) : identity.toString();
            boolean odd = digits.length() % 2 == 1;
            out.octet((digits.charAt(0) - '0') << 4
                    | (odd ? ODD : 0)
                    | identity.type().code());
            SemiOctets.write(out, digits, 1);
        }
    }

    /** Reads an identity's value: an IMSI, IMEI, IMEISV or TMSI. */
    public static MobileIdentity read(MessageReader in) throws ProtocolViolation {
        if (in.remaining() > MAX_LENGTH) {
            throw ProtocolViolation.invalid("a mobile identity of " + in.remaining() + " octets");
        }
        int first = in.octet("mobile identity");
        MobileIdentity.Type type = Coded.find(MobileIdentity.Type.values(), first & 0x07)
                .orElseThrow(() -> ProtocolViolation.invalid(
                        "mobile identity type " + (first & 0x07) + " where IMSI, IMEI, IMEISV or TMSI was expected"));
        try {
            return switch (type) {
                case IMSI -> new Imsi(digits(first, in));
                case IMEI -> new Imei(Imei.transmitted(digits(first, in)));
                case TMSI -> new Tmsi((int) in.fourOctets("TMSI"));
                case IMEISV -> new Imeisv(digits(first, in));
            };
        } catch (IllegalArgumentException wrong) {
            throw ProtocolViolation.invalid(wrong.getMessage());
        }
    }

    private static String digits(int first, MessageReader in) throws ProtocolViolation {
        int count = 2 * in.remaining() + ((first & ODD) != 0 ? 1 : 0);
        return digit(first >> 4) + SemiOctets.readDecimal(in, Math.max(0, count - 1));
    }

    static void writeArea(OctetWriter out, LocationArea area) {
        String mcc = area.countryCode();
        String mnc = area.networkCode();
        int thirdMncDigit = mnc.length() == 3 ? mnc.charAt(2) - '0' : 0x0f;
        out.octet((mcc.charAt(1) - '0') << 4 | mcc.charAt(0) - '0');
        out.octet(thirdMncDigit << 4 | mcc.charAt(2) - '0');
        out.octet((mnc.charAt(1) - '0') << 4 | mnc.charAt(0) - '0');
        out.twoOctets(area.areaCode());
    }

    static LocationArea readArea(MessageReader in) throws ProtocolViolation {
        int first = in.octet("location area");
        int second = in.octet("location area");
        int third = in.octet("location area");
        String mcc = "" + digit(first) + digit(first >> 4) + digit(second);
        String mnc = "" + digit(third) + digit(third >> 4) + (second >> 4 == 0x0f ? "" : digit(second >> 4));
        return new LocationArea(mcc, mnc, in.twoOctets("location area code"));
    }

    private static char digit(int nibble) throws ProtocolViolation {
        if ((nibble & 0x0f) > 9) {
            throw ProtocolViolation.invalid("a digit of value " + (nibble & 0x0f));
        }
        return (char) ('0' + (nibble & 0x0f));
    }
}
