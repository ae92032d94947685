package simgsm.modem.at.state;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.Map;
import java.util.TreeMap;
import simgsm.octets.OctetWriter;
import simgsm.octets.Octets;
import simgsm.sms.GsmAlphabet;
import simgsm.station.context.StationIdentity;

/** The elementary files of the SIM read by clients (TS 51.011, 10), made from the terminal's identity. */
public final class SimFiles {
    /** Status words and the data read, as hexadecimal digits (TS 27.007, 8.18; TS 51.011, 9.4). */
    public record Answer(int status1, int status2, String data) {}

    /** @param recordLength 0 for a transparent file */
    private record File(byte[] content, int recordLength) {}

    private static final int READ_BINARY = 176;
    private static final int READ_RECORD = 178;
    private static final int GET_RESPONSE = 192;
    private static final int STATUS = 242;

    private static final Answer NOT_FOUND = new Answer(148, 4, "");
    private static final Answer WRONG_LENGTH = new Answer(103, 0, "");
    private static final Answer OUT_OF_RANGE = new Answer(148, 2, "");
    private static final Answer UNKNOWN_INSTRUCTION = new Answer(109, 0, "");

    private static final int ICCID = 0x2fe2;
    private static final int LANGUAGES = 0x6f05;
    private static final int IMSI = 0x6f07;
    private static final int SERVICES = 0x6f38;
    private static final int MSISDN = 0x6f40;
    private static final int SMS_PARAMETERS = 0x6f42;
    private static final int SPN = 0x6f46;
    private static final int LOCATION = 0x6f7e;
    private static final int ADMINISTRATIVE_DATA = 0x6fad;
    private static final int PHASE = 0x6fae;
    private static final int EMERGENCY_CODES = 0x6fb7;

    private static final int FILLER = 0xff;
    private static final int SPN_LETTERS = 16;
    private static final int UNKNOWN = 0x81;

    private final Map<Integer, File> files = new TreeMap<>();
    private final String iccid;

    public SimFiles(StationIdentity identity, String operatorName) {
        String imsi = identity.imsi().digits();
        iccid = withCheckDigit(("89" + imsi + "000000000000000000").substring(0, 18));
        transparent(ICCID, digits(iccid, 10));
        transparent(LANGUAGES, new byte[] {1});
        OctetWriter subscriber = new OctetWriter().octet(8);
        subscriber.bytes(digits("9" + imsi, 8));
        transparent(IMSI, subscriber.toOctetString().toArray());
        transparent(SERVICES, new byte[] {(byte) 0xff, (byte) 0x33, 0x0f, 0, 0});
        linear(MSISDN, number(identity.number().digits(), 14));
        linear(SMS_PARAMETERS, smsParameters(identity));
        transparent(SPN, serviceProvider(operatorName));
        transparent(LOCATION, HexFormat.of().parseHex("ffffffff00f110000100" + "00"));
        transparent(ADMINISTRATIVE_DATA, new byte[] {0, 0, 0, 2});
        transparent(PHASE, new byte[] {2});
        byte[] emergency = filled(15);
        System.arraycopy(digits("112", 3), 0, emergency, 0, 3);
        transparent(EMERGENCY_CODES, emergency);
    }

    public String iccid() {
        return iccid;
    }

    private void transparent(int identifier, byte[] content) {
        files.put(identifier, new File(content, 0));
    }

    private void linear(int identifier, byte[] record) {
        files.put(identifier, new File(record, record.length));
    }

    private static byte[] filled(int length) {
        byte[] octets = new byte[length];
        Arrays.fill(octets, (byte) FILLER);
        return octets;
    }

    /** Digits in pairs, the first in the lower half. */
    private static byte[] digits(String digits, int length) {
        byte[] octets = filled(length);
        for (int i = 0; i < digits.length() && i / 2 < length; i++) {
            int digit = Character.digit(digits.charAt(i), 16);
            int other = octets[i / 2] & (i % 2 == 0 ? 0xf0 : 0x0f);
            octets[i / 2] = (byte) (other | (i % 2 == 0 ? digit : digit << 4));
        }
        return octets;
    }

    /** Length, type and digits of a number at the end of a record with an empty name. */
    private static byte[] number(String number, int fromEnd) {
        byte[] record = filled(fromEnd);
        record[0] = (byte) ((number.length() + 1) / 2 + 1);
        record[1] = (byte) UNKNOWN;
        System.arraycopy(digits(number, 10), 0, record, 2, 10);
        return record;
    }

    /** Contains only the service centre's number (TS 51.011, 10.5.6). */
    private static byte[] smsParameters(StationIdentity identity) {
        byte[] record = filled(28);
        record[0] = (byte) 0xfd;
        System.arraycopy(number(identity.serviceCenter().digits(), 12), 0, record, 13, 12);
        return record;
    }

    private static byte[] serviceProvider(String name) {
        byte[] octets = filled(1 + SPN_LETTERS);
        octets[0] = 0;
        byte[] codes = GsmAlphabet.encodes(name) ? GsmAlphabet.encode(name) : new byte[0];
        System.arraycopy(codes, 0, octets, 1, Math.min(SPN_LETTERS, codes.length));
        return octets;
    }

    /** The last digit is Luhn's (ITU-T E.118). */
    private static String withCheckDigit(String digits) {
        int sum = 0;
        for (int i = 0; i < digits.length(); i++) {
            int digit = digits.charAt(digits.length() - 1 - i) - '0';
            int weighted = i % 2 == 0 ? 2 * digit : digit;
            sum += weighted / 10 + weighted % 10;
        }
        return digits + (10 - sum % 10) % 10;
    }

    /** Performs one command; files cannot be changed. @param length P3, 0 for all */
    public Answer access(int command, int identifier, int p1, int p2, int length) {
        if (command == STATUS) {
            return new Answer(144, 0, "");
        }
        if (command != READ_BINARY && command != READ_RECORD && command != GET_RESPONSE) {
            return UNKNOWN_INSTRUCTION;
        }
        File file = files.get(identifier);
        if (file == null) {
            return NOT_FOUND;
        }
        return switch (command) {
            case READ_BINARY -> read(file, p1 << 8 | p2, length);
            case READ_RECORD -> p1 == 1 && file.recordLength() > 0 ? read(file, 0, length) : OUT_OF_RANGE;
            default -> part(header(identifier, file), 0, length);
        };
    }

    private static Answer read(File file, int from, int length) {
        return part(file.content(), from, length);
    }

    private static Answer part(byte[] content, int from, int length) {
        int count = length == 0 ? content.length - from : length;
        if (from > content.length || from + count > content.length || count < 0) {
            return WRONG_LENGTH;
        }
        byte[] data = Octets.range(content, from, from + count);
        return new Answer(144, 0, HexFormat.of().withUpperCase().formatHex(data));
    }

    /** The description of an elementary file (TS 51.011, 9.2.1). */
    private static byte[] header(int identifier, File file) {
        OctetWriter out = new OctetWriter().twoOctets(0).twoOctets(file.content().length);
        out.twoOctets(identifier)
                .octet(4)
                .octet(0)
                .octet(0x15)
                .octet(0xff)
                .octet(0xff)
                .octet(1);
        out.octet(2).octet(file.recordLength() > 0 ? 1 : 0).octet(file.recordLength());
        return out.toOctetString().toArray();
    }
}
