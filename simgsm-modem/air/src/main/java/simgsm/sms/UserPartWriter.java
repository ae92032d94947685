package simgsm.sms;

import simgsm.air.Septets;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** Header and text into one user part. */
final class UserPartWriter {
    private UserPartWriter() {}

    /** @param header its own length first, or empty for none */
    static UserData write(String text, Alphabet alphabet, byte[] header) {
        boolean hasHeader = header.length > 0;
        DataCodingScheme coding = DataCodingScheme.of(alphabet);
        if (alphabet == Alphabet.GSM_7BIT) {
            byte[] codes = GsmAlphabet.encode(text);
            int headerSeptets = (header.length * 8 + 6) / 7;
            int fillBits = headerSeptets * 7 - header.length * 8;
            return new UserData(
                    hasHeader, coding, headerSeptets + codes.length, joined(header, Septets.pack(codes, fillBits)));
        }
        OctetString octets = joined(header, Ucs2.encode(text));
        return new UserData(hasHeader, coding, octets.length(), octets);
    }

    private static OctetString joined(byte[] header, byte[] text) {
        return OctetString.of(new OctetWriter().bytes(header).bytes(text).toArray());
    }
}
