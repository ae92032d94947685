package simgsm.tools;

import java.io.PrintStream;
import java.util.Locale;
import java.util.StringJoiner;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;
import simgsm.sms.MessageSplitter;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.trace.TpduText;

/** {@code pdu encode TEXT} and {@code pdu decode HEX}: short messages as octets and back. */
final class PduTool {
    private PduTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws UsageException {
        if (arguments.rest().size() < 2) {
            throw new UsageException("expected encode TEXT or decode HEX");
        }
        String direction = arguments.rest().get(0);
        String input = arguments.rest().get(1);
        int reference = arguments.value("ref", PduTool::reference).orElse(0);
        try {
            switch (direction) {
                case "encode" -> out.print(encode(input, reference) + "\n");
                case "decode" -> out.print(decode(input) + "\n");
                default -> throw new UsageException("expected encode or decode, found " + direction);
            }
        } catch (IllegalArgumentException e) {
            err.println("simgsm-modem: pdu " + direction + ": " + e.getMessage());
            return ExitStatus.FAILED;
        }
        out.flush();
        return ExitStatus.OK;
    }

    /**
     * One user part per line, {@code udhi,dcs,udl,ud-hex}, all numbers decimal.
     *
     * @param reference of the message, 0 to 255; used with several parts only
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    static String encode(String text, int reference) {
        StringJoiner lines = new StringJoiner("\n");
        for (UserData part : MessageSplitter.split(text, reference)) {
            lines.add((part.hasHeader() ? 1 : 0) + "," + part.coding().octet() + "," + part.length() + ","
                    + part.octets());
        }
        return lines.toString();
    }

    /**
     * A SUBMIT, DELIVER or STATUS-REPORT in words, one field per line as {@code name: value}. Blanks in the digits
     * are ignored.
     *
     * @throws IllegalArgumentException for anything else, naming the fault
     */
    static String decode(String hex) {
        OctetString octets = octets(hex);
        try {
            return TpduText.of(decode(octets), Locale.ROOT);
        } catch (ProtocolViolation violation) {
            throw new IllegalArgumentException("not a TPDU: " + violation.getMessage(), violation);
        }
    }

    /** Reads a TPDU, alone or after the address of its service centre, as in AT commands and phone software. */
    private static Tpdu decode(OctetString octets) throws ProtocolViolation {
        Direction direction = isSubmit(octets) ? Direction.UPLINK : Direction.DOWNLINK;
        try {
            return TpduCodec.decode(octets, direction);
        } catch (ProtocolViolation violation) {
            int address = octets.length() == 0 ? 0 : 1 + octets.octet(0);
            boolean hasAddress = address == 1
                    || address >= 3 && address <= 12 && address < octets.length() && (octets.octet(1) & 0x80) != 0;
            if (!hasAddress) {
                throw violation;
            }
            OctetString tpdu = OctetString.of(Octets.range(octets.toArray(), address, octets.length()));
            return TpduCodec.decode(tpdu, isSubmit(tpdu) ? Direction.UPLINK : Direction.DOWNLINK);
        }
    }

    private static OctetString octets(String hex) {
        try {
            return OctetString.ofHex(hex.replaceAll("\\s", ""));
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException("a TPDU is an even number of hexadecimal digits", wrong);
        }
    }

    private static boolean isSubmit(OctetString octets) {
        return octets.length() > 0 && (octets.octet(0) & 0x03) == 1;
    }

    private static int reference(String text) {
        if (!text.matches("[0-9A-Fa-f]{1,2}")) {
            throw new IllegalArgumentException("expected one or two hexadecimal digits, found " + text);
        }
        return Integer.parseInt(text, 16);
    }
}
