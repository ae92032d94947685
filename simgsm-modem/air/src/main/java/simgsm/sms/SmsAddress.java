package simgsm.sms;

import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.SemiOctets;
import simgsm.octets.OctetWriter;
import simgsm.octets.Septets;

/**
 * TP-OA, TP-DA, TP-RA: a number, or a name in letters (TS 23.040, 9.1.2.5).
 *
 * @param type type of number, 0 unknown, 1 international, 5 letters ... 7
 * @param plan numbering plan, 1 for ISDN (E.164) ... 15
 * @param value digits of 0-9 * # a-c, at most 20, or at most 11 characters of the GSM alphabet for letters
 */
public record SmsAddress(int type, int plan, String value) {
    public static final int UNKNOWN = 0;
    public static final int INTERNATIONAL = 1;
    public static final int LETTERS = 5;

    private static final int ISDN = 1;
    private static final int MAX_DIGITS = 20;
    private static final String DIGITS = "0123456789*#abc";
    private static final int MAX_SEPTETS = 11;
    private static final int NO_EXTENSION = 0x80;

    public SmsAddress {
        if (type < 0 || type > 7 || plan < 0 || plan > 15) {
            throw new IllegalArgumentException("type of number " + type + " or plan " + plan + " is out of range");
        }
        boolean fits = type == LETTERS
                ? GsmAlphabet.encodes(value) && GsmAlphabet.encode(value).length <= MAX_SEPTETS
                : value.length() <= MAX_DIGITS && areDigits(value);
        if (!fits) {
            throw new IllegalArgumentException("\"" + value + "\" is no short message address");
        }
    }

    public static SmsAddress of(Msisdn number) {
        return new SmsAddress(number.international() ? INTERNATIONAL : UNKNOWN, ISDN, number.digits());
    }

    /** The name of a sender, such as a service. */
    public static SmsAddress ofLetters(String name) {
        return new SmsAddress(LETTERS, 0, name);
    }

    /** The telephone number; empty for letters and for the digits * # a-c. */
    public Optional<Msisdn> number() {
        boolean isNumber = type != LETTERS && !value.isEmpty() && value.length() <= Msisdn.MAX_DIGITS;
        for (int i = 0; isNumber && i < value.length(); i++) {
            isNumber = value.charAt(i) >= '0' && value.charAt(i) <= '9';
        }
        return isNumber ? Optional.of(new Msisdn(value, type == INTERNATIONAL)) : Optional.empty();
    }

    private static boolean areDigits(String value) {
        for (int i = 0; i < value.length(); i++) {
            if (DIGITS.indexOf(value.charAt(i)) < 0) {
                return false;
            }
        }
        return true;
    }

    void write(OctetWriter out) {
        byte[] codes = type == LETTERS ? GsmAlphabet.encode(value) : new byte[0];
        out.octet(type == LETTERS ? (codes.length * 7 + 3) / 4 : value.length());
        out.octet(NO_EXTENSION | type << 4 | plan);
        if (type == LETTERS) {
            out.bytes(Septets.pack(codes, 0));
        } else {
            SemiOctets.write(out, value, 0);
        }
    }

    static SmsAddress read(MessageReader in) throws ProtocolViolation {
        int halfOctets = in.octet("address length");
        if (halfOctets > MAX_DIGITS) {
            throw ProtocolViolation.invalid("an address of " + halfOctets + " digits, at most " + MAX_DIGITS);
        }
        int typeAndPlan = in.octet("type of address");
        int type = typeAndPlan >> 4 & 0x07;
        MessageReader value = in.part((halfOctets + 1) / 2, "address");
        String text = type == LETTERS ? letters(value, halfOctets) : SemiOctets.readCounted(value, halfOctets);
        return new SmsAddress(type, typeAndPlan & 0x0f, text);
    }

    private static String letters(MessageReader value, int halfOctets) {
        int septets = Math.min(MAX_SEPTETS, halfOctets * 4 / 7);
        String text = GsmAlphabet.decode(Septets.unpack(value.rest().toArray(), septets, 0));
        return GsmAlphabet.encode(text).length > MAX_SEPTETS ? "" : text;
    }

    /** An international number with its plus sign. */
    @Override
    public String toString() {
        return type == INTERNATIONAL ? "+" + value : value;
    }
}
