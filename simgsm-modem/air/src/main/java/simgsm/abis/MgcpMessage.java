package simgsm.abis;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;

/**
 * A message of MGCP 1.0 (RFC 3435) on stream {@link IpaFrame#MGCP}: the centre creates and deletes the media
 * connections of a terminal. Other lines are ignored.
 *
 * @param head the first line: a command with transaction and endpoint, or a return code with the transaction
 * @param transaction 1 to 999999999
 * @param call C: identifier of the call; empty in answers
 * @param connection I: identifier of the connection
 * @param media the sender's address for RTP
 */
public record MgcpMessage(
        Head head, int transaction, Optional<String> call, Optional<String> connection, Optional<MediaAddress> media) {
    /** Commands, and the answers in use. */
    public enum Head {
        CREATE_CONNECTION("CRCX"),
        DELETE_CONNECTION("DLCX"),
        OK("200"),
        DELETED("250"),
        /** Insufficient resources: the endpoint has no port for media. */
        NO_RESOURCES("403");

        private final String word;

        Head(String word) {
            this.word = word;
        }

        private boolean isCommand() {
            return this == CREATE_CONNECTION || this == DELETE_CONNECTION;
        }
    }

    /**
     * An address that receives RTP. @param host an IP address in digits @param port even; RTCP would use the next one
     */
    public record MediaAddress(String host, int port) {}

    private static final String END_OF_LINE = "\r\n";
    private static final Pattern FIRST_LINE = Pattern.compile("([A-Z]{4}|[0-9]{3}) ([0-9]{1,9})(?: .*)?");
    private static final Pattern HOST = Pattern.compile("c=IN IP[46] ([0-9a-fA-F.:]+)");
    private static final Pattern PORT = Pattern.compile("m=audio ([0-9]{1,5}) .*");

    /** CRCX: requests speech to this address, and the terminal's own address in the answer. */
    public static MgcpMessage create(int transaction, String call, MediaAddress center) {
        return new MgcpMessage(
                Head.CREATE_CONNECTION, transaction, Optional.of(call), Optional.empty(), Optional.of(center));
    }

    /** DLCX: ends the connection. */
    public static MgcpMessage delete(int transaction, String call, String connection) {
        return delete(transaction, call, Optional.of(connection));
    }

    /** DLCX. @param connection empty for all connections of the call */
    public static MgcpMessage delete(int transaction, String call, Optional<String> connection) {
        return new MgcpMessage(Head.DELETE_CONNECTION, transaction, Optional.of(call), connection, Optional.empty());
    }

    /** The answer to CRCX. */
    public MgcpMessage created(String newConnection, MediaAddress terminal) {
        return new MgcpMessage(
                Head.OK, transaction, Optional.empty(), Optional.of(newConnection), Optional.of(terminal));
    }

    /** An answer without further lines. */
    public MgcpMessage answered(Head code) {
        return new MgcpMessage(code, transaction, Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** The text's octets. */
    public byte[] encode() {
        StringBuilder text = new StringBuilder(head.word).append(' ').append(transaction);
        text.append(head.isCommand() ? " rtpbridge/" + call.orElse("1") + "@mgw MGCP 1.0" : reason());
        line(text, "");
        call.ifPresent(id -> line(text, "C: " + id));
        connection.ifPresent(id -> line(text, "I: " + id));
        if (head == Head.CREATE_CONNECTION) {
            line(text, "L: p:20, a:PCMA");
            line(text, "M: sendrecv");
        }
        media.ifPresent(address -> describe(text, address));
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private String reason() {
        return head == Head.OK || head == Head.DELETED ? " OK" : " FAIL";
    }

    private static void line(StringBuilder text, String line) {
        text.append(line).append(END_OF_LINE);
    }

    /** SDP (RFC 4566) with the payload types of {@link RtpPacket}. */
    private void describe(StringBuilder text, MediaAddress address) {
        String net = "IN " + (address.host().contains(":") ? "IP6 " : "IP4 ") + address.host();
        line(text, "");
        line(text, "v=0");
        line(text, "o=- " + transaction + " 1 " + net);
        line(text, "s=-");
        line(text, "c=" + net);
        line(text, "t=0 0");
        line(text, "m=audio " + address.port() + " RTP/AVP " + RtpPacket.A_LAW + " " + RtpPacket.GSM_FULL_RATE);
        line(text, "a=rtpmap:" + RtpPacket.A_LAW + " PCMA/8000");
        line(text, "a=rtpmap:" + RtpPacket.GSM_FULL_RATE + " GSM/8000");
        line(text, "a=ptime:20");
    }

    /** @throws ProtocolViolation for any other text */
    public static MgcpMessage decode(byte[] octets) throws ProtocolViolation {
        String[] lines = new String(octets, StandardCharsets.US_ASCII).split("\r?\n", -1);
        Matcher first = FIRST_LINE.matcher(lines[0]);
        if (!first.matches()) {
            throw new ProtocolViolation(Cause.PROTOCOL_ERROR, "an MGCP command or answer was expected");
        }
        Optional<String> call = Optional.empty();
        Optional<String> connection = Optional.empty();
        Optional<String> host = Optional.empty();
        Optional<Integer> port = Optional.empty();
        for (String line : lines) {
            Matcher toHost = HOST.matcher(line);
            Matcher toPort = PORT.matcher(line);
            if (line.startsWith("C: ")) {
                call = Optional.of(line.substring(3));
            } else if (line.startsWith("I: ")) {
                connection = Optional.of(line.substring(3));
            } else if (toHost.matches()) {
                host = Optional.of(toHost.group(1));
            } else if (toPort.matches()) {
                port = Optional.of(Integer.parseInt(toPort.group(1))).filter(number -> number <= 0xffff);
            }
        }
        Optional<Integer> toPort = port;
        return new MgcpMessage(
                head(first.group(1)),
                Integer.parseInt(first.group(2)),
                call,
                connection,
                host.flatMap(address -> toPort.map(number -> new MediaAddress(address, number))));
    }

    private static Head head(String word) throws ProtocolViolation {
        for (Head head : Head.values()) {
            if (head.word.equals(word)) {
                return head;
            }
        }
        throw new ProtocolViolation(Cause.MESSAGE_TYPE_NON_EXISTENT, "MGCP " + word + " is not known here");
    }
}
