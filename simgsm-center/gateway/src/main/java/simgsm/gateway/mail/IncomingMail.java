package simgsm.gateway.mail;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a mail says.
 *
 * @param id its Message-ID with brackets, may be empty
 * @param isAutomatic no person has written it (RFC 3834): it is never an order and never answered
 * @param failure of an own mail, as a notice of non-delivery says it; empty for all others
 * @param text without quoted lines and signature, at most 1 000 characters
 */
record IncomingMail(String id, String subject, boolean isAutomatic, Optional<Failure> failure, String text) {
    /**
     * An own mail that has failed.
     *
     * @param receiver empty if the notice does not name it
     * @param status of RFC 3463
     */
    record Failure(String receiver, String status) {}

    private static final int MOST_CHARACTERS = 1_000;
    /** Characters of HTML that are read; bounds the work of its patterns. */
    private static final int MOST_HTML = 8_000;

    private static final Set<String> BULK = Set.of("bulk", "junk", "list");
    private static final Pattern QUOTE = Pattern.compile("(On|El|Am|Le)\\b.*(wrote|escribió|schrieb|a écrit)\\s*:");
    private static final Pattern STATUS = Pattern.compile(
            "^Status:\\s*([45]\\.[0-9]{1,3}\\.[0-9]{1,3})", Pattern.MULTILINE | Pattern.CASE_INSENSITIVE);
    private static final Pattern RECEIVER = Pattern.compile(
            "^Final-Recipient:[^;\n]*;\\s*([A-Za-z0-9.@_+-]{1,100})", Pattern.MULTILINE | Pattern.CASE_INSENSITIVE);
    /** In a notice: the mail that has failed was itself automatic. */
    private static final Pattern ABOUT_AUTOMATIC =
            Pattern.compile("^Auto-Submitted:\\s*auto", Pattern.MULTILINE | Pattern.CASE_INSENSITIVE);

    /** @param sender of the envelope; empty for a notice */
    static IncomingMail read(String sender, String octets) {
        MimePart mail = MimePart.parse(octets);
        String submitted = mail.header("auto-submitted").toLowerCase(Locale.ROOT);
        boolean isAutomatic = sender.isEmpty()
                || (sender + " " + mail.header("from")).toLowerCase(Locale.ROOT).contains("mailer-daemon@")
                || !submitted.isEmpty() && !submitted.split("[ ;(]")[0].equals("no")
                || BULK.contains(mail.header("precedence").toLowerCase(Locale.ROOT))
                || mail.headers().containsKey("list-id");
        Optional<Failure> failure =
                !isAutomatic || ABOUT_AUTOMATIC.matcher(mail.body()).find()
                        ? Optional.empty()
                        : mail.find("message/delivery-status").flatMap(part -> failure(part.text()));
        String id = mail.header("message-id");
        return new IncomingMail(
                id.matches("<[!-~]{1,250}>") ? id : "",
                mail.header("subject"),
                isAutomatic,
                failure,
                ownWords(textOf(mail)));
    }

    private static Optional<Failure> failure(String status) {
        Matcher code = STATUS.matcher(status);
        Matcher receiver = RECEIVER.matcher(status);
        return !code.find()
                ? Optional.empty()
                : Optional.of(new Failure(receiver.find() ? receiver.group(1) : "", code.group(1)));
    }

    private static String textOf(MimePart mail) {
        Optional<String> plain = mail.find("text/plain").map(MimePart::text);
        return plain.or(() -> mail.find("text/html").map(part -> withoutTags(part.text())))
                .orElse("(no text)");
    }

    private static String withoutTags(String whole) {
        String html = whole.substring(0, Math.min(whole.length(), MOST_HTML));
        return html.replaceAll("(?is)<(script|style|head)\\b.*?</\\1>", "")
                .replaceAll("\\s+", " ")
                .replaceAll("(?i)<(br|/p|/div|/tr)\\b[^>]*>", "\n")
                .replaceAll("<[^>]*>", "")
                .replace("&nbsp;", " ")
                .replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&quot;", "\"")
                .replace("&#39;", "'")
                .replace("&amp;", "&");
    }

    private static String ownWords(String text) {
        StringBuilder own = new StringBuilder();
        for (String line : text.split("\n", -1)) {
            if (line.equals("-- ") || QUOTE.matcher(line.strip()).matches()) {
                break;
            }
            if (!line.startsWith(">")) {
                own.append(line.stripTrailing()).append('\n');
            }
        }
        String all = own.toString().strip();
        int end = all.codePointCount(0, all.length()) <= MOST_CHARACTERS
                ? all.length()
                : all.offsetByCodePoints(0, MOST_CHARACTERS);
        return all.substring(0, end);
    }

    /** The first line, if it is an order: keys only, and begun with a star; else empty. */
    Optional<String> order() {
        return text.lines().findFirst().map(String::strip).filter(line -> line.matches("\\*[ 0-9*#A-D]*"));
    }
}
