package simgsm.gateway.sip;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.speech.SpeechCodec;

/**
 * What a session description (RFC 4566, RFC 3264) says of its first usable audio stream.
 *
 * @param remote where the peer receives speech
 * @param codec PCMA or PCMU
 * @param eventType payload type of telephone-event (RFC 4733)
 * @param isReceiving false while the peer holds the call
 * @param isSending false if the peer only listens
 * @param media the description's m= lines
 * @param chosen index of the stream's m= line
 */
record Sdp(
        SipPeer remote,
        SpeechCodec.Kind codec,
        OptionalInt eventType,
        boolean isReceiving,
        boolean isSending,
        List<String> media,
        int chosen) {
    /** Payload type of telephone-event in offers of this side. */
    static final int OFFERED_EVENTS = 101;

    private static final String NO_ADDRESS = "0.0.0.0";
    /** IPv4, or IPv6 by its colon: a name would be looked up for each packet. */
    private static final String ADDRESS =
            "((25[0-5]|(2[0-4]|1?[0-9])?[0-9])(\\.(?!$)|$)){4}|[0-9a-fA-F.]*:[0-9a-fA-F.:]*";

    /** Lines of one m= section; the first has the lines before any m=. */
    private static List<List<String>> sections(String text) {
        List<List<String>> sections = new ArrayList<>();
        sections.add(new ArrayList<>());
        text.lines().map(String::strip).forEach(line -> {
            if (line.startsWith("m=")) {
                sections.add(new ArrayList<>());
            }
            sections.get(sections.size() - 1).add(line);
        });
        return sections;
    }

    /** Empty if no stream of the description can be used: no PCMA or PCMU over RTP/AVP. */
    static Optional<Sdp> parse(String text) {
        List<List<String>> sections = sections(text);
        List<String> session = sections.remove(0);
        List<String> media = sections.stream().map(lines -> lines.get(0)).toList();
        for (int i = 0; i < media.size(); i++) {
            Optional<Sdp> stream = stream(session, sections.get(i), media, i);
            if (stream.isPresent()) {
                return stream;
            }
        }
        return Optional.empty();
    }

    private static Optional<Sdp> stream(List<String> session, List<String> lines, List<String> media, int index) {
        String[] words = media.get(index).substring(2).split("\\s+");
        if (words.length < 4
                || !words[0].equals("audio")
                || !words[1].matches("[1-9][0-9]{0,4}")
                || !words[2].equals("RTP/AVP")
                || Integer.parseInt(words[1]) > 0xffff) {
            return Optional.empty();
        }
        List<String> formats = List.of(words).subList(3, words.length);
        Optional<SpeechCodec.Kind> codec = formats.contains("8")
                ? Optional.of(SpeechCodec.Kind.A_LAW)
                : formats.contains("0") ? Optional.of(SpeechCodec.Kind.MU_LAW) : Optional.empty();
        String address = connection(lines).or(() -> connection(session)).orElse("");
        if (codec.isEmpty() || !address.matches(ADDRESS)) {
            return Optional.empty();
        }
        String direction = direction(lines).or(() -> direction(session)).orElse("sendrecv");
        boolean isReceiving = direction.endsWith("recv") || direction.equals("recvonly");
        return Optional.of(new Sdp(
                new SipPeer(address, Integer.parseInt(words[1])),
                codec.get(),
                eventType(lines, formats),
                isReceiving && !address.equals(NO_ADDRESS),
                direction.startsWith("send"),
                media,
                index));
    }

    private static Optional<String> connection(List<String> lines) {
        return lines.stream()
                .filter(line -> line.startsWith("c=IN IP"))
                .map(line -> line.substring(2).split("[\\s/]+"))
                .filter(words -> words.length >= 3)
                .map(words -> words[2])
                .findFirst();
    }

    private static Optional<String> direction(List<String> lines) {
        return lines.stream()
                .filter(line -> line.matches("a=(sendrecv|sendonly|recvonly|inactive)"))
                .map(line -> line.substring(2))
                .findFirst();
    }

    private static OptionalInt eventType(List<String> lines, List<String> formats) {
        return lines.stream()
                .map(line -> line.toLowerCase(Locale.ROOT))
                .filter(line -> line.matches("a=rtpmap:[0-9]{1,3}\\s+telephone-event/8000.*"))
                .map(line -> line.substring("a=rtpmap:".length()).split("\\s+")[0])
                .filter(formats::contains)
                .mapToInt(Integer::parseInt)
                .findFirst();
    }

    /** An offer of this side. @param version of the description in its session */
    static String offer(String host, int port, int version) {
        return head(host, version) + audio(port, "8 0 " + OFFERED_EVENTS)
                + "a=rtpmap:8 PCMA/8000\r\na=rtpmap:0 PCMU/8000\r\n" + events(OFFERED_EVENTS)
                + "a=ptime:20\r\na=sendrecv\r\n";
    }

    /** The answer to this description: one stream with the peer's numbers, the others refused by port 0. */
    String answer(String host, int port, int version) {
        StringBuilder text = new StringBuilder(head(host, version));
        for (int i = 0; i < media.size(); i++) {
            if (i != chosen) {
                text.append(media.get(i).replaceFirst("\\s+[0-9/]+\\s+", " 0 ")).append("\r\n");
                continue;
            }
            String formats = codec.payloadType() + (eventType.isPresent() ? " " + eventType.getAsInt() : "");
            text.append(audio(port, formats))
                    .append("a=rtpmap:")
                    .append(codec.payloadType())
                    .append(codec == SpeechCodec.Kind.A_LAW ? " PCMA" : " PCMU")
                    .append("/8000\r\n");
            eventType.ifPresent(type -> text.append(events(type)));
            text.append("a=ptime:20\r\na=").append(answeredDirection()).append("\r\n");
        }
        return text.toString();
    }

    private String answeredDirection() {
        return isReceiving ? isSending ? "sendrecv" : "sendonly" : isSending ? "recvonly" : "inactive";
    }

    private static String head(String host, int version) {
        String family = host.indexOf(':') >= 0 ? "IN IP6 " : "IN IP4 ";
        return "v=0\r\no=simgsm 1 " + version + " " + family + host + "\r\ns=-\r\nc=" + family + host + "\r\nt=0 0\r\n";
    }

    private static String audio(int port, String formats) {
        return "m=audio " + port + " RTP/AVP " + formats + "\r\n";
    }

    /** Keys only: event 16 is flash. */
    private static String events(int type) {
        return "a=rtpmap:" + type + " telephone-event/8000\r\na=fmtp:" + type + " 0-15\r\n";
    }
}
