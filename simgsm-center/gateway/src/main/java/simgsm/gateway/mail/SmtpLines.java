package simgsm.gateway.mail;

import java.nio.ByteBuffer;

/** Splits a stream of octets into lines that end with CR LF; a character is an octet. */
final class SmtpLines {
    private final int most;
    private final StringBuilder unread = new StringBuilder();
    private int start;

    /** @param most octets of a line, without its end */
    SmtpLines(int most) {
        this.most = most;
    }

    void accept(ByteBuffer octets) {
        unread.delete(0, start);
        start = 0;
        while (octets.hasRemaining()) {
            unread.append((char) (octets.get() & 0xff));
        }
    }

    /** The next line without its end; null if none is complete. */
    String next() {
        int end = unread.indexOf("\r\n", start);
        if (end < 0) {
            return null;
        }
        String line = unread.substring(start, end);
        start = end + 2;
        return line;
    }

    int length() {
        return unread.length() - start;
    }

    /** True if the unread line is longer than permitted. */
    boolean isTooLong() {
        int end = unread.indexOf("\r\n", start);
        return (end < 0 ? unread.length() : end) - start > most + 1;
    }
}
