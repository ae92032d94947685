package simgsm.modem.client;

import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * A command to a modem and the form of its answer.
 *
 * @param text the command line without its end
 * @param payload text for the prompt, as of {@code +CMGS}
 * @param prefix of the answer's lines, such as {@code +CLCC:}; empty for any line
 * @param shape form of the answer's lines
 * @param timeoutNanos from the sending to the final result
 */
record ModemCommand(String text, Optional<String> payload, String prefix, Shape shape, long timeoutNanos) {
    /** The lines of an answer before its final result. */
    enum Shape {
        /** None; {@link #prefix} is ignored. */
        RESULT_ONLY,
        /** Lines that begin with the prefix. */
        PREFIXED,
        /** A line that begins with the prefix, then lines of any text, as of {@code +CMGR}. */
        PREFIXED_WITH_BODY,
        /** Lines of any text, as of {@code +CGMI}. */
        FREE,
        /** None; the call's end is a final result, too, as of {@code ATA}. */
        CALL
    }

    private static final long USUAL_MILLIS = 5_000;

    private ModemCommand(String text, Optional<String> payload, String prefix, Shape shape, int millis) {
        this(text, payload, prefix, shape, TimeUnit.MILLISECONDS.toNanos(millis));
    }

    /** Answered by a final result only. */
    static ModemCommand of(String text) {
        return new ModemCommand(text, Optional.empty(), "", Shape.RESULT_ONLY, (int) USUAL_MILLIS);
    }

    /** Answered by lines with this prefix. */
    static ModemCommand query(String text, String prefix) {
        return new ModemCommand(text, Optional.empty(), prefix, Shape.PREFIXED, (int) USUAL_MILLIS);
    }

    /** Answered by lines of text. */
    static ModemCommand free(String text) {
        return new ModemCommand(text, Optional.empty(), "", Shape.FREE, (int) USUAL_MILLIS);
    }

    /** Answered by lines with this prefix, each followed by lines of text. */
    static ModemCommand listing(String text, String prefix) {
        return new ModemCommand(text, Optional.empty(), prefix, Shape.PREFIXED_WITH_BODY, 20_000);
    }

    /** Answers or ends a call. */
    static ModemCommand ofCall(String text) {
        return new ModemCommand(text, Optional.empty(), "", Shape.CALL, 20_000);
    }

    /** Followed by a text at a prompt; a network may take a minute to accept a short message. */
    static ModemCommand prompting(String text, String payload, String prefix) {
        return new ModemCommand(text, Optional.of(payload), prefix, Shape.PREFIXED, 60_000);
    }

    /** True if a line repeats the command's name, as some modems do in answers to a command without lines. */
    boolean isNamedIn(String line) {
        String name = text.replaceFirst("^AT", "").replaceFirst("[^+A-Z0-9].*$", "");
        return name.startsWith("+") && line.startsWith(name + ":");
    }

    ModemCommand within(long millis) {
        return new ModemCommand(text, payload, prefix, shape, TimeUnit.MILLISECONDS.toNanos(millis));
    }
}
