package simgsm.gateway.mail;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A mail, or one part of it (RFC 2045, 2046).
 *
 * @param headers unfolded, by name in lower case; the first of equal ones
 * @param body as sent; a character is an octet
 */
record MimePart(Map<String, String> headers, String body) {
    private static final int MOST_DEPTH = 8;
    private static final int MOST_PARTS = 100;
    private static final Pattern HEADERS_END = Pattern.compile("(?:^|\r?\n)[ \t]*\r?\n");
    private static final Pattern ENCODED_WORD = Pattern.compile("=\\?([^?*]+)(?:\\*[^?]*)?\\?([bBqQ])\\?([^?]*)\\?=");

    static MimePart parse(String octets) {
        Map<String, String> headers = new HashMap<>();
        Matcher end = HEADERS_END.matcher(octets);
        boolean hasBody = end.find();
        String head = hasBody ? octets.substring(0, end.start()) : octets;
        for (String line : head.replaceAll("\r?\n[ \t]+", " ").split("\n")) {
            int colon = line.indexOf(':');
            if (colon > 0) {
                String name = line.substring(0, colon).strip().toLowerCase(Locale.ROOT);
                headers.putIfAbsent(name, line.substring(colon + 1).strip());
            }
        }
        return new MimePart(headers, hasBody ? octets.substring(end.end()) : "");
    }

    /** A header's text, with encoded words decoded (RFC 2047); empty if it is missing. */
    String header(String name) {
        String value = headers.getOrDefault(name, "").replaceAll("\\?=[ \t]+=\\?", "?==?");
        Matcher word = ENCODED_WORD.matcher(value);
        return word.replaceAll(match -> {
            String text = match.group(3);
            byte[] octets = match.group(2).equalsIgnoreCase("B") ? base64(text) : quoted(text.replace('_', ' '));
            return Matcher.quoteReplacement(new String(octets, charset(match.group(1))));
        });
    }

    /** The media type in lower case; text/plain if it is missing. */
    private String type() {
        String value = headers.getOrDefault("content-type", "").split(";")[0];
        return value.isBlank() ? "text/plain" : value.strip().toLowerCase(Locale.ROOT);
    }

    private String parameter(String name) {
        Matcher value = Pattern.compile(
                        ";\\s*" + name + "\\s*=\\s*(?:\"([^\"]*)\"|([^\\s;]+))", Pattern.CASE_INSENSITIVE)
                .matcher(headers.getOrDefault("content-type", ""));
        return !value.find() ? "" : value.group(1) != null ? value.group(1) : value.group(2);
    }

    /** The first part of this media type, in depth. */
    Optional<MimePart> find(String type) {
        return find(type, MOST_DEPTH);
    }

    private Optional<MimePart> find(String type, int depth) {
        if (type().equals(type)) {
            return Optional.of(this);
        }
        if (!type().startsWith("multipart/") || depth == 0) {
            return Optional.empty();
        }
        for (MimePart part : parts()) {
            Optional<MimePart> found = part.find(type, depth - 1);
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    private List<MimePart> parts() {
        String boundary = "--" + parameter("boundary");
        List<MimePart> parts = new ArrayList<>();
        StringBuilder part = null;
        for (String line : body.split("\n", -1)) {
            String end = line.stripTrailing();
            if (end.equals(boundary) || end.equals(boundary + "--")) {
                if (part != null) {
                    parts.add(parse(part.toString()));
                }
                part = end.equals(boundary) && parts.size() < MOST_PARTS ? new StringBuilder() : null;
            } else if (part != null) {
                part.append(line).append('\n');
            }
        }
        if (part != null) {
            parts.add(parse(part.toString()));
        }
        return parts;
    }

    /** The body with its encoding undone, in its charset. */
    String text() {
        byte[] octets =
                switch (headers.getOrDefault("content-transfer-encoding", "").toLowerCase(Locale.ROOT)) {
                    case "base64" -> base64(body);
                    case "quoted-printable" -> quoted(body.replaceAll("=[ \t]*\r?\n", ""));
                    default -> body.getBytes(StandardCharsets.ISO_8859_1);
                };
        return new String(octets, charset(parameter("charset"))).replaceAll("\r\n?", "\n");
    }

    private static Charset charset(String name) {
        try {
            return name.isEmpty() || name.equalsIgnoreCase("us-ascii") ? StandardCharsets.UTF_8 : Charset.forName(name);
        } catch (IllegalArgumentException e) {
            return StandardCharsets.ISO_8859_1;
        }
    }

    private static byte[] base64(String text) {
        String digits = text.replaceAll("[^A-Za-z0-9+/]", "");
        // a single digit at the end holds no octet
        String whole = digits.length() % 4 == 1 ? digits.substring(0, digits.length() - 1) : digits;
        return Base64.getDecoder().decode(whole);
    }

    /** Undoes =XX of quoted-printable and of Q. */
    private static byte[] quoted(String text) {
        String octets = Pattern.compile("=([0-9A-Fa-f]{2})")
                .matcher(text)
                .replaceAll(
                        match -> Matcher.quoteReplacement(String.valueOf((char) Integer.parseInt(match.group(1), 16))));
        return octets.getBytes(StandardCharsets.ISO_8859_1);
    }
}
