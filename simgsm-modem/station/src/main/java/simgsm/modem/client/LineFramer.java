package simgsm.modem.client;

import java.util.function.Consumer;

/**
 * Splits the octets of a modem into lines: CR, LF or both end a line, empty lines are dropped, and partial lines wait
 * for the rest. An octet that is not printable becomes {@link #NOISE}. The prompt, which has no line end, is
 * recognised only while it is expected.
 */
final class LineFramer {
    /** The longest PDU has 352 digits; the rest of longer lines is dropped. */
    static final int MAX_CHARACTERS = 1024;

    /** Replaces an octet that is not printable. */
    static final char NOISE = '\ufffd';

    private static final String PROMPT = "> ";

    private final Consumer<String> lines;
    private final Runnable prompt;
    private final StringBuilder line = new StringBuilder();
    private boolean promptExpected;

    LineFramer(Consumer<String> lines, Runnable prompt) {
        this.lines = lines;
        this.prompt = prompt;
    }

    void accept(byte[] octets) {
        for (byte octet : octets) {
            accept(octet & 0xff);
        }
    }

    private void accept(int octet) {
        if (octet == '\r' || octet == '\n') {
            endLine();
            return;
        }
        if (line.length() < MAX_CHARACTERS) {
            line.append(octet >= ' ' && octet != 0x7f ? (char) octet : NOISE);
        }
        if (promptExpected && line.indexOf(PROMPT) == 0) {
            line.setLength(0);
            prompt.run();
        }
    }

    private void endLine() {
        String whole = line.toString().strip();
        line.setLength(0);
        if (!whole.isEmpty()) {
            lines.accept(whole);
        }
    }

    void expectPrompt(boolean expected) {
        promptExpected = expected;
    }

    /** Drops the partial line. @return true if there was one */
    boolean drop() {
        boolean waited = line.length() > 0;
        line.setLength(0);
        return waited;
    }
}
