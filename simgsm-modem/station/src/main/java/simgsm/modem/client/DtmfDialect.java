package simgsm.modem.client;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.dtmf.DtmfKey;

/** The forms of DTMF reports by families of modems, from the modules' manuals. */
public enum DtmfDialect {
    /**
     * SIM800 and SIM900. The interval, the least time between two equal keys, must be 0, or the second star of an
     * order's opening is lost; the report includes the duration if the modem supports it.
     */
    SIM800("SIMCOM", "+DTMF:", true, false, "AT+DDET=1,0,1", "AT+DDET=1,0", "AT+DDET=1"),
    /** SIM7100 to SIM7600; enabled by the commands of SIM800. */
    SIM7000("SIMCOM", "+RXDTMF:", false, false),
    TELIT("TELIT", "#DTMFEV:", false, false, "AT#DTMF=1"),
    /** The key is the decimal number of its ASCII character. */
    QUECTEL("QUECTEL", "+QTONEDET:", false, true, "AT+QTONEDET=1"),
    U_BLOX("U-BLOX", "+UUDTMFD:", false, false, "AT+UDTMFD=1,2");

    /** A key, and a further number, the duration in some dialects. */
    private static final Pattern KEY = Pattern.compile("\\s*([0-9A-Da-d*#])\\s*(?:,\\s*([0-9]{1,5})\\s*)?");

    private static final Pattern ASCII = Pattern.compile("\\s*([0-9]{2,3})\\s*");
    /** Single tones reported by SIM800 when asked to detect them. */
    private static final Pattern SINGLE_TONE = Pattern.compile("\\s*(1400|2300)\\s*");

    private final String manufacturer;
    private final String prefix;
    private final boolean hasDuration;
    private final boolean isAscii;
    private final List<String> enablers;

    DtmfDialect(String manufacturer, String prefix, boolean hasDuration, boolean isAscii, String... enablers) {
        this.manufacturer = manufacturer;
        this.prefix = prefix;
        this.hasDuration = hasDuration;
        this.isAscii = isAscii;
        this.enablers = List.of(enablers);
    }

    /**
     * A report.
     *
     * @param key empty for a single tone
     * @param millis duration of the key, if given
     */
    record Report(Optional<DtmfKey> key, OptionalInt millis) {}

    /** The commands that enable reports, the best first; the first accepted one is used. */
    public List<String> enablers() {
        return enablers;
    }

    /** True if a modem with this manufacturer's name is of the family. */
    boolean isOf(String manufacturerText) {
        return manufacturerText.toUpperCase(Locale.ROOT).contains(manufacturer);
    }

    /** The dialect of a line that looks like a report. */
    static Optional<DtmfDialect> ofReport(String line) {
        return Arrays.stream(values())
                .filter(dialect -> line.startsWith(dialect.prefix))
                .findFirst();
    }

    /** Reads a report, with or without a blank before the key; empty if it is damaged. */
    Optional<Report> read(String line) {
        String value = line.substring(prefix.length());
        if (SINGLE_TONE.matcher(value).matches()) {
            return Optional.of(new Report(Optional.empty(), OptionalInt.empty()));
        }
        return isAscii ? ascii(value) : plain(value);
    }

    private static Optional<Report> ascii(String value) {
        Matcher number = ASCII.matcher(value);
        if (!number.matches()) {
            return Optional.empty();
        }
        char symbol = (char) Integer.parseInt(number.group(1));
        return DtmfKey.isKey(symbol)
                ? Optional.of(new Report(Optional.of(DtmfKey.of(symbol)), OptionalInt.empty()))
                : Optional.empty();
    }

    private Optional<Report> plain(String value) {
        Matcher matcher = KEY.matcher(value);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        DtmfKey key = DtmfKey.of(matcher.group(1).toUpperCase(Locale.ROOT).charAt(0));
        OptionalInt millis = hasDuration && matcher.group(2) != null
                ? OptionalInt.of(Integer.parseInt(matcher.group(2)))
                : OptionalInt.empty();
        return Optional.of(new Report(Optional.of(key), millis));
    }
}
