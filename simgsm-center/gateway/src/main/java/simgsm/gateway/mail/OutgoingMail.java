package simgsm.gateway.mail;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A mail from a number (RFC 5322).
 *
 * @param id left part of the Message-ID, equal whenever the same message is sent again
 * @param name of the receiver, may be empty
 * @param answered Message-ID of the mail that is answered
 * @param isAutomatic an answer that no person has written
 */
record OutgoingMail(
        String id,
        String number,
        String domain,
        List<String> to,
        String name,
        String subject,
        String text,
        Optional<String> answered,
        boolean isAutomatic,
        Instant date) {
    /** Octets of a line of text that is sent as it is; RFC 5321 permits 998. */
    private static final int MOST_PLAIN_LINE = 900;
    /** Characters of a line of quoted-printable (RFC 2045, 6.7). */
    private static final int QUOTED_LINE = 72;
    /** Octets in an encoded word of at most 75 characters (RFC 2047, 2). */
    private static final int WORD_OCTETS = 42;

    private static final DateTimeFormatter DATE = DateTimeFormatter.ofPattern(
                    "EEE, d MMM yyyy HH:mm:ss xx", Locale.ROOT)
            .withZone(ZoneOffset.UTC);

    String from() {
        return number + "@" + domain;
    }

    /** The mail with doubled dots, as octets after DATA, the final dot included; a character is an octet. */
    String withDots(boolean takesEightBits) {
        return octets(takesEightBits).replace("\r\n.", "\r\n..") + ".\r\n";
    }

    private String octets(boolean takesEightBits) {
        String body = utf8(text.replaceAll("\r\n?|\n", "\r\n") + "\r\n");
        boolean isAscii = body.chars().allMatch(c -> c < 0x80);
        boolean isPlain = (isAscii || takesEightBits)
                && body.lines().allMatch(line -> line.length() <= MOST_PLAIN_LINE)
                && body.chars().allMatch(c -> c >= ' ' || c == '\r' || c == '\n' || c == '\t');
        StringBuilder mail = new StringBuilder();
        header(mail, "Date", DATE.format(date));
        header(mail, "From", "<" + from() + ">");
        String addresses = "<" + String.join(">,\r\n <", to) + ">";
        header(mail, "To", name.isEmpty() ? addresses : encoded(name, "[A-Za-z0-9 ]") + " " + addresses);
        header(mail, "Subject", encoded(subject, "[ -~&&[^=\"<>]]"));
        header(mail, "Message-ID", "<" + id + "@" + domain + ">");
        answered.ifPresent(before -> {
            header(mail, "In-Reply-To", before);
            header(mail, "References", before);
        });
        if (isAutomatic) {
            header(mail, "Auto-Submitted", "auto-replied");
        }
        header(mail, "MIME-Version", "1.0");
        header(mail, "Content-Type", "text/plain; charset=utf-8");
        header(mail, "Content-Transfer-Encoding", !isPlain ? "quoted-printable" : isAscii ? "7bit" : "8bit");
        return mail.append("\r\n")
                .append(isPlain ? body : quotedPrintable(body))
                .toString();
    }

    private static void header(StringBuilder mail, String name, String value) {
        mail.append(name).append(": ").append(value).append("\r\n");
    }

    private static String utf8(String text) {
        return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
    }

    /** A header's text; encoded words where it is not short and of plain characters (RFC 2047). */
    private static String encoded(String text, String plain) {
        if (text.matches(plain + "{0,60}")) {
            return text;
        }
        StringBuilder words = new StringBuilder();
        StringBuilder word = new StringBuilder();
        for (int c : text.codePoints().toArray()) {
            String octets = utf8(Character.toString(c < ' ' ? ' ' : c));
            if (word.length() + octets.length() > WORD_OCTETS) {
                words.append(encodedWord(word)).append("\r\n ");
                word.setLength(0);
            }
            word.append(octets);
        }
        return words.append(encodedWord(word)).toString();
    }

    private static String encodedWord(CharSequence octets) {
        byte[] value = octets.toString().getBytes(StandardCharsets.ISO_8859_1);
        return "=?utf-8?B?" + Base64.getEncoder().encodeToString(value) + "?=";
    }

    private static String quotedPrintable(String octets) {
        StringBuilder quoted = new StringBuilder();
        for (String line : octets.split("\r\n", -1)) {
            int length = 0;
            for (int i = 0; i < line.length(); i++) {
                char c = line.charAt(i);
                boolean isPlain = c > ' ' && c <= '~' && c != '=' || c == ' ' && i < line.length() - 1;
                String piece = isPlain ? String.valueOf(c) : "=%02X".formatted((int) c);
                if (length + piece.length() > QUOTED_LINE) {
                    quoted.append("=\r\n");
                    length = 0;
                }
                quoted.append(piece);
                length += piece.length();
            }
            quoted.append("\r\n");
        }
        return quoted.substring(0, quoted.length() - 2);
    }
}
