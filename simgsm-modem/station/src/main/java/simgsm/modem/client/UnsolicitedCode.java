package simgsm.modem.client;

import java.util.Arrays;
import java.util.Optional;

/** Unsolicited codes of modems (TS 27.005, TS 27.007, and modules' manuals). Keys are in {@link DtmfDialect}. */
enum UnsolicitedCode {
    /** An incoming call, repeated while it rings; {@code +CRING} after {@code +CRC=1}. */
    RING("RING", "+CRING:"),
    /** The caller's number, after each RING. */
    CALLER("+CLIP:"),
    CALL_ENDED("NO CARRIER", "BUSY", "NO ANSWER", "NO DIALTONE", "VOICE CALL: END"),
    CALL_WAITS("+CCWA:"),
    /** A short message is in memory at this index. */
    MESSAGE_STORED("+CMTI:"),
    /** A message, a status report or a broadcast: a line of text follows. */
    MESSAGE_BODY("+CMT:", "+CDS:", "+CBM:"),
    REGISTRATION("+CREG:"),
    /** The modem has started or stops: a call has ended, and its settings are lost. */
    BOOT("RDY", "^SYSSTART", "NORMAL POWER DOWN", "UNDER-VOLTAGE POWER DOWN", "OVER-VOLTAGE POWER DOWN"),
    /** Follows a start within seconds; implies one if none was seen. */
    STARTED("Call Ready", "SMS Ready", "+CPIN:", "+CFUN:", "PB DONE"),
    /** Ignored. */
    NEWS(
            "+CGREG:",
            "+CEREG:",
            "+CIEV:",
            "+CTZV:",
            "+CUSD:",
            "+CSSI:",
            "+CSSU:",
            "+COLP:",
            "*PSUTTZ",
            "*PSNWID",
            "DST:",
            "+QIND:",
            "MISSED_CALL",
            "VOICE CALL: BEGIN",
            "UNDER-VOLTAGE WARN",
            "OVER-VOLTAGE WARN",
            "^");

    private final String[] beginnings;

    UnsolicitedCode(String... beginnings) {
        this.beginnings = beginnings;
    }

    /** True if the next line belongs to the code, whatever its content. */
    boolean hasBody() {
        return this == MESSAGE_BODY;
    }

    /** The code at a line's beginning; a code without a colon is the whole line, or its first word. */
    static Optional<UnsolicitedCode> of(String line) {
        return Arrays.stream(values())
                .filter(code -> Arrays.stream(code.beginnings).anyMatch(beginning -> begins(line, beginning)))
                .findFirst();
    }

    private static boolean begins(String line, String beginning) {
        return line.startsWith(beginning)
                && (beginning.endsWith(":")
                        || beginning.length() == 1
                        || line.length() == beginning.length()
                        || !Character.isLetterOrDigit(line.charAt(beginning.length())));
    }
}
