package simgsm.ss;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;
import simgsm.ss.Component.Invoke;

/**
 * Interprets typed codes (TS 22.030, 6.5.2 and annex B): a supplementary service such as {@code *#21#}, or USSD for
 * all others.
 */
public final class ServiceCode {
    /** The equipment's identity (TS 22.030, 6.6), answered by the terminal. */
    public static final String IMEI = "*#06#";

    /** Prefix of a number: shows or hides one's own number in this call (TS 22.030, annex B). */
    private static final String SHOWING = "*31#";

    private static final String HIDING = "#31#";

    /** Procedure, service code, supplementary information A, B and C. */
    private static final Pattern FORM =
            Pattern.compile("(\\*\\*|\\*#|##|\\*|#)([0-9]{2,3})(?:\\*([0-9+]*)(?:\\*([0-9]*)(?:\\*([0-9]{0,3}))?)?)?#");

    /** First SS-Code of call forwarding (TS 24.080, 4.5). */
    private static final int FORWARDING = 0x20;

    private static final int GROUP = 0xf0;

    /** SS-Code by the typed service code. */
    private static final Map<String, Integer> SERVICES = new HashMap<>();

    /** Basic service groups (TS 22.030, annex C): tag of teleservice or bearer service, and code (TS 29.002, 17.7.9 and 17.7.10). */
    private static final Map<String, Integer> GROUPS = new HashMap<>();

    static {
        GROUPS.putAll(Map.of("10", 0x8300, "11", 0x8311, "12", 0x8370, "13", 0x8360, "16", 0x8320, "19", 0x8380));
        GROUPS.putAll(Map.of("20", 0x8200, "21", 0x8260, "22", 0x8268, "24", 0x8258, "25", 0x8250));
        SERVICES.putAll(Map.of("30", 0x11, "31", 0x12, "76", 0x13, "77", 0x14, "43", 0x41));
        SERVICES.putAll(Map.of("002", 0x20, "21", 0x21, "004", 0x28, "67", 0x29, "61", 0x2a, "62", 0x2b));
        SERVICES.putAll(Map.of(
                "330", 0x90, "333", 0x91, "33", 0x92, "331", 0x93, "332", 0x94, "353", 0x99, "35", 0x9a, "351", 0x9b));
    }

    private ServiceCode() {}

    /** True if the green key sends the typed text as a code instead of calling it (TS 22.030, 6.5.3.2). */
    public static boolean isCode(String typed) {
        return typed.endsWith("#");
    }

    /** True if a call is typed that hides one's own number. */
    public static boolean isHidingCall(String typed) {
        return typed.startsWith(HIDING) && !isCode(typed);
    }

    /** The number called by a typed text. */
    public static String called(String typed) {
        return typed.startsWith(SHOWING) || typed.startsWith(HIDING) ? typed.substring(SHOWING.length()) : typed;
    }

    /**
     * The operation for a typed code.
     *
     * @param id invoke identifier
     * @throws IllegalArgumentException for a text that USSD does not accept; see {@link UssdText#of}
     */
    public static Invoke invoke(int id, String typed) {
        Matcher form = FORM.matcher(typed);
        if (form.matches() && SERVICES.containsKey(form.group(2))) {
            int service = SERVICES.get(form.group(2));
            boolean isForwarding = (service & GROUP) == FORWARDING;
            String number = isForwarding ? text(form.group(3)) : "";
            String group = text(form.group(isForwarding ? 4 : 3));
            SsOperation operation = operation(form.group(1), isForwarding, number);
            if (group.isEmpty() || GROUPS.containsKey(group)) {
                Optional<Integer> seconds = Optional.of(text(form.group(5)))
                        .filter(text -> !text.isEmpty() && operation == SsOperation.REGISTER_SS)
                        .map(Integer::valueOf);
                return new Invoke(id, operation, argument(operation, service, number, group, seconds));
            }
        }
        return new Invoke(
                id,
                SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST,
                UssdText.of(typed).encode());
    }

    /** {@code *} registers a forwarding with a number, and activates everything else. */
    private static SsOperation operation(String procedure, boolean isForwarding, String information) {
        return switch (procedure) {
            case "**" -> SsOperation.REGISTER_SS;
            case "*#" -> SsOperation.INTERROGATE_SS;
            case "##" -> SsOperation.ERASE_SS;
            case "#" -> SsOperation.DEACTIVATE_SS;
            default -> isForwarding && !information.isEmpty() ? SsOperation.REGISTER_SS : SsOperation.ACTIVATE_SS;
        };
    }

    private static String text(String typed) {
        return typed == null ? "" : typed;
    }

    private static OctetString argument(
            SsOperation operation, int service, String number, String group, Optional<Integer> seconds) {
        boolean isNumber = number.matches("\\+?[0-9]{1," + Msisdn.MAX_DIGITS + "}");
        return new SsArgument(
                        service,
                        Optional.ofNullable(GROUPS.get(group)),
                        operation == SsOperation.REGISTER_SS && isNumber ? Optional.of(number) : Optional.empty(),
                        seconds)
                .encode();
    }
}
