package simgsm.tools;

import java.io.PrintStream;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Options;
import simgsm.console.UsageException;
import simgsm.sms.PduTool;

/** {@code pdu encode TEXT} and {@code pdu decode HEX}: short messages as octets and back. */
final class SmsTool implements Tool {
    @Override
    public String word() {
        return "pdu";
    }

    @Override
    public Options options() {
        return new Options(
                        "java -jar simgsm-modem.jar pdu encode [--ref HH] TEXT | pdu decode HEX",
                        "encode: one user part of the short message a line, as udhi,dcs,udl,ud-hex.\n"
                                + "decode: a SUBMIT, DELIVER or STATUS-REPORT in words.")
                .value("ref", "HH", "encode: reference of a message of several parts, hexadecimal (00)")
                .arguments(2);
    }

    @Override
    public int run(Arguments arguments, PrintStream out, PrintStream err) throws UsageException {
        if (arguments.rest().size() < 2) {
            throw new UsageException("expected encode TEXT or decode HEX");
        }
        String direction = arguments.rest().get(0);
        String input = arguments.rest().get(1);
        int reference = arguments.value("ref", SmsTool::reference).orElse(0);
        try {
            switch (direction) {
                case "encode" -> out.print(PduTool.encode(input, reference) + "\n");
                case "decode" -> out.print(PduTool.decode(input) + "\n");
                default -> throw new UsageException("expected encode or decode, found " + direction);
            }
        } catch (IllegalArgumentException e) {
            err.println("simgsm-modem: pdu " + direction + ": " + e.getMessage());
            return ExitStatus.FAILED;
        }
        out.flush();
        return ExitStatus.OK;
    }

    private static int reference(String text) {
        if (!text.matches("[0-9A-Fa-f]{1,2}")) {
            throw new IllegalArgumentException("expected one or two hexadecimal digits, found " + text);
        }
        return Integer.parseInt(text, 16);
    }
}
