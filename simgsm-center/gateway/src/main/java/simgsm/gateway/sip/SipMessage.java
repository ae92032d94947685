package simgsm.gateway.sip;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A SIP message (RFC 3261, 7): start line, header fields in their order, body. Reads compact names, folded fields and
 * lines that end with LF alone.
 */
final class SipMessage {
    private static final String VERSION = "SIP/2.0";
    /** Compact names (7.3.3). */
    private static final Map<String, String> COMPACT = Map.ofEntries(
            Map.entry("v", "via"),
            Map.entry("f", "from"),
            Map.entry("t", "to"),
            Map.entry("m", "contact"),
            Map.entry("i", "call-id"),
            Map.entry("l", "content-length"),
            Map.entry("c", "content-type"),
            Map.entry("e", "content-encoding"),
            Map.entry("k", "supported"),
            Map.entry("s", "subject"));

    private record Field(String name, String value) {
        boolean is(String other) {
            String lower = name.toLowerCase(Locale.ROOT);
            return COMPACT.getOrDefault(lower, lower).equals(other.toLowerCase(Locale.ROOT));
        }
    }

    /** Method, or version. */
    private final String first;
    /** URI, or status. */
    private final String second;
    /** Version, or reason. */
    private final String third;

    private final List<Field> fields = new ArrayList<>();
    private byte[] body = {};

    private SipMessage(String first, String second, String third) {
        this.first = first;
        this.second = second;
        this.third = third;
    }

    static SipMessage request(String method, String uri) {
        return new SipMessage(method, uri, VERSION);
    }

    /** A response with the fields that it shares with its request (8.2.6.2). */
    SipMessage response(int status, String reason) {
        SipMessage response = new SipMessage(VERSION, Integer.toString(status), reason);
        fields.stream()
                .filter(field -> field.is("via")
                        || field.is("from")
                        || field.is("to")
                        || field.is("call-id")
                        || field.is("cseq")
                        || field.is("record-route"))
                .forEach(response.fields::add);
        return response;
    }

    /** @throws SipSyntaxException naming what is wrong */
    static SipMessage parse(byte[] octets) throws SipSyntaxException {
        // Latin-1 keeps each octet, so the body's place is found in the text.
        String text = new String(octets, StandardCharsets.ISO_8859_1);
        int end = text.indexOf("\r\n\r\n");
        int gap = 4;
        if (end < 0) {
            end = text.indexOf("\n\n");
            gap = 2;
        }
        if (end < 0) {
            end = octets.length;
            gap = 0;
        }
        String head = new String(octets, 0, end, StandardCharsets.UTF_8).replaceAll("\r?\n[ \t]+", " ");
        String[] lines = head.split("\r?\n");
        String[] start = lines[0].split(" ", 3);
        if (start.length < 3 || !start[0].equals(VERSION) && !start[2].strip().equals(VERSION)) {
            throw new SipSyntaxException("expected a start line of SIP/2.0");
        }
        if (start[0].equals(VERSION) && !start[1].matches("[1-6][0-9][0-9]")) {
            throw new SipSyntaxException("expected a status of three digits");
        }
        SipMessage message = new SipMessage(start[0], start[1], start[2].strip());
        for (int i = 1; i < lines.length; i++) {
            int colon = lines[i].indexOf(':');
            if (colon <= 0) {
                throw new SipSyntaxException("expected name: value in header field " + i);
            }
            message.with(
                    lines[i].substring(0, colon).strip(),
                    lines[i].substring(colon + 1).strip());
        }
        message.readBody(octets, end + gap);
        return message;
    }

    /** Content-Length may be missing over UDP (18.3); what follows the body is dropped. */
    private void readBody(byte[] octets, int from) throws SipSyntaxException {
        int length = octets.length - from;
        Optional<String> given = header("Content-Length");
        if (given.isPresent()) {
            if (!given.get().matches("[0-9]{1,6}") || Integer.parseInt(given.get()) > length) {
                throw new SipSyntaxException("expected a Content-Length of at most " + length);
            }
            length = Integer.parseInt(given.get());
        }
        body = Arrays.copyOfRange(octets, from, from + length);
    }

    byte[] encode() {
        StringBuilder head = new StringBuilder(first + " " + second + " " + third + "\r\n");
        fields.stream()
                .filter(field -> !field.is("content-length"))
                .forEach(field ->
                        head.append(field.name).append(": ").append(field.value).append("\r\n"));
        head.append("Content-Length: ").append(body.length).append("\r\n\r\n");
        byte[] octets = head.toString().getBytes(StandardCharsets.UTF_8);
        byte[] all = Arrays.copyOf(octets, octets.length + body.length);
        System.arraycopy(body, 0, all, octets.length, body.length);
        return all;
    }

    /** Appends a field. */
    SipMessage with(String name, String value) {
        fields.add(new Field(name, value));
        return this;
    }

    /** Replaces the first field of this name, or appends it. */
    SipMessage replace(String name, String value) {
        for (int i = 0; i < fields.size(); i++) {
            if (fields.get(i).is(name)) {
                fields.set(i, new Field(name, value));
                return this;
            }
        }
        return with(name, value);
    }

    SipMessage withBody(String type, String text) {
        body = text.getBytes(StandardCharsets.UTF_8);
        return replace("Content-Type", type);
    }

    boolean isRequest() {
        return !first.equals(VERSION);
    }

    /** The method of a request, or of the request that a response answers. */
    String method() {
        return isRequest() ? first : cseqPart(1);
    }

    String uri() {
        return second;
    }

    /** The status of a response. */
    int status() {
        return Integer.parseInt(second);
    }

    /** The first field of this name. */
    Optional<String> header(String name) {
        return fields.stream().filter(field -> field.is(name)).map(Field::value).findFirst();
    }

    /** All values of a field that may hold several, parted by commas (7.3.1). */
    List<String> values(String name) {
        return fields.stream()
                .filter(field -> field.is(name))
                .flatMap(field -> SipValue.split(field.value, ',').stream())
                .filter(value -> !value.isEmpty())
                .toList();
    }

    /** All fields of a name whose value may contain commas. */
    List<String> fields(String name) {
        return fields.stream().filter(field -> field.is(name)).map(Field::value).toList();
    }

    SipValue address(String name) {
        return SipValue.parse(header(name).orElse(""));
    }

    SipValue via() {
        List<String> all = values("Via");
        return SipValue.parse(all.isEmpty() ? "" : all.get(0));
    }

    String callId() {
        return header("Call-ID").orElse("");
    }

    /** The number in CSeq; -1 if it is missing or wrong. */
    long cseq() {
        String number = cseqPart(0);
        return number.matches("[0-9]{1,10}") ? Long.parseLong(number) : -1;
    }

    private String cseqPart(int index) {
        String[] parts = header("CSeq").orElse("").strip().split("\\s+");
        return parts.length > index ? parts[index] : "";
    }

    byte[] body() {
        return body;
    }

    String text() {
        return new String(body, StandardCharsets.UTF_8);
    }

    /** Type and subtype of the body in lower case, without parameters. */
    String contentType() {
        return SipValue.parse(header("Content-Type").orElse("")).main().toLowerCase(Locale.ROOT);
    }

    /** True if a request has the fields that each needs (8.1.1). */
    boolean isComplete() {
        return cseq() >= 0
                && method().equals(cseqPart(1))
                && !callId().isEmpty()
                && !via().main().isEmpty()
                && !address("From").main().isEmpty()
                && !address("To").main().isEmpty();
    }

    /** Adds the source to the first Via (18.2.1, RFC 3581, 4). */
    void receivedFrom(SipPeer peer) {
        List<String> vias = new ArrayList<>(values("Via"));
        fields.removeIf(field -> field.is("via"));
        String first = vias.get(0).replaceAll(";\\s*rport\\s*(=[0-9]*)?", "").replaceAll(";\\s*received\\s*=[^;]*", "");
        String rport = SipValue.parse(vias.get(0)).parameters().containsKey("rport") ? ";rport=" + peer.port() : "";
        vias.set(0, first + ";received=" + peer.host() + rport);
        for (int i = vias.size() - 1; i >= 0; i--) {
            fields.add(0, new Field("Via", vias.get(i)));
        }
    }

    /** A short description for logs. */
    @Override
    public String toString() {
        return isRequest() ? first + " " + second : second + " " + third;
    }
}
