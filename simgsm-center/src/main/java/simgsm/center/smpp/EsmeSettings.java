package simgsm.center.smpp;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The settings of one application, from its lines in the file of applications.
 *
 * @param alphabet of data_coding 0 and 1 in both directions; empty: the GSM alphabet for 0, ASCII for 1 (5.2.19)
 * @param window unanswered deliver_sm of a session
 * @param requestsPerSecond of each session; empty: the limit for its address
 * @param retries true if a deliver_sm refused with this status is sent again; other statuses follow the standard
 */
public record EsmeSettings(
        Optional<EsmeAlphabet> alphabet, int window, OptionalInt requestsPerSecond, Map<Integer, Boolean> retries) {
    /** Settings of an application without lines. */
    public static final EsmeSettings STANDARD =
            new EsmeSettings(Optional.empty(), DeliveryWindow.SIZE, OptionalInt.empty(), Map.of());

    static final int MAX_WINDOW = 10_000;
    static final int MAX_RATE = 1_000_000;

    /** The setting read by {@link NumberOwners}. */
    static final String NUMBERS = "numbers";

    private static final String RETRY = "retry.";

    /** Coding of an application's text with data_coding 0 and 1. */
    public enum EsmeAlphabet {
        GSM,
        LATIN1,
        ASCII
    }

    /** True if the name after the system id is a setting. */
    static boolean isSetting(String name) {
        return name.equals(NUMBERS)
                || name.equals("alphabet")
                || name.equals("window")
                || name.equals("rate")
                || name.startsWith(RETRY);
    }

    /**
     * These settings with one changed.
     *
     * @param name {@code alphabet}, {@code window}, {@code rate} or {@code retry.STATUS}
     * @throws IllegalArgumentException naming the expected value
     */
    EsmeSettings with(String name, String value) {
        return switch (name) {
            case "alphabet" -> new EsmeSettings(Optional.of(alphabet(value)), window, requestsPerSecond, retries);
            case "window" -> new EsmeSettings(alphabet, number(value, MAX_WINDOW), requestsPerSecond, retries);
            case "rate" -> new EsmeSettings(alphabet, window, OptionalInt.of(number(value, MAX_RATE)), retries);
            default -> {
                Map<Integer, Boolean> changed = new HashMap<>(retries);
                changed.put(status(name.substring(RETRY.length())), isRetry(value));
                yield new EsmeSettings(alphabet, window, requestsPerSecond, Map.copyOf(changed));
            }
        };
    }

    private static EsmeAlphabet alphabet(String value) {
        for (EsmeAlphabet each : EsmeAlphabet.values()) {
            if (each.name().toLowerCase(Locale.ROOT).equals(value)) {
                return each;
            }
        }
        throw new IllegalArgumentException("expected gsm, latin1 or ascii, found \"" + value + "\"");
    }

    private static int number(String value, int most) {
        if (value.matches("[0-9]{1,9}")) {
            int number = Integer.parseInt(value);
            if (number >= 1 && number <= most) {
                return number;
            }
        }
        throw new IllegalArgumentException("expected a number of 1 to " + most + ", found \"" + value + "\"");
    }

    private static int status(String text) {
        if (text.matches("0x[0-9a-fA-F]{1,8}")) {
            return Integer.parseUnsignedInt(text.substring(2), 16);
        }
        throw new IllegalArgumentException("expected retry.0x and a command_status, found \"" + RETRY + text + "\"");
    }

    private static boolean isRetry(String value) {
        if (value.equals("retry") || value.equals("drop")) {
            return value.equals("retry");
        }
        throw new IllegalArgumentException("expected drop or retry, found \"" + value + "\"");
    }
}
