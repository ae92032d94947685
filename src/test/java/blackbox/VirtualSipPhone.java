package blackbox;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.gateway.sip.SipPeer;
import simgsm.speech.G711;

/** A SIP phone of a {@link VirtualSip}, made of raw datagrams, so that it can be wrong in any way. */
final class VirtualSipPhone {
    final SipPeer signalling;
    final SipPeer speech;
    /** Keys heard in the speech. */
    final List<Character> tones = new ArrayList<>();

    final Deque<String> received = new ArrayDeque<>();
    /** The type of telephone-event that the phone names and sends. */
    int eventType = 101;
    /** Appended to each request. */
    String extra = "";

    String password = VirtualSip.PASSWORD;
    String algorithm = "MD5";
    String callId = "call";
    String fromTag = "a1";
    String toTag = "";
    int cseq = 1;
    int heardPackets;
    private final VirtualSip sip;
    private final String number;
    private final DtmfReceiver receiver =
            new DtmfReceiver(digit -> tones.add(digit.key().symbol()));
    private int branch;
    /** All requests with one branch. */
    boolean keepsBranch;

    private int mediaPort;
    private int sequence = 65_530;
    private int timestamp = 1000;
    private int nonceCount;

    VirtualSipPhone(VirtualSip sip, String number) {
        this.sip = sip;
        this.number = number;
        String host = "192.0.2.2";
        signalling = new SipPeer(host, Integer.parseInt(number) % 10_000 + 10_000);
        speech = new SipPeer(host, Integer.parseInt(number) % 10_000 + 40_000);
        sip.plug(this);
    }

    void arrived(byte[] octets) {
        received.add(new String(octets, StandardCharsets.UTF_8));
    }

    void heard(byte[] rtp) {
        heardPackets++;
        short[] samples = new short[160];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = G711.A_LAW.expand(rtp[12 + i]);
        }
        receiver.accept(samples);
    }

    /** Sends a text whose lines end with LF, as lines with CR LF. */
    void say(String text) {
        sip.toServer(text.replace("\n", "\r\n").getBytes(StandardCharsets.UTF_8), signalling);
        sip.suite.settle();
    }

    /** The next message that begins so; what came before is dropped. */
    String expect(String beginning) {
        for (int tenths = 0; tenths < 400; tenths++) {
            while (!received.isEmpty()) {
                String next = received.poll();
                if (next.startsWith(beginning)) {
                    return next;
                }
            }
            sip.suite.seconds(0.1);
        }
        return fail("no " + beginning + " within 40 s");
    }

    static String field(String message, String name) {
        Matcher field = Pattern.compile("(?mi)^" + name + ": *(.*?)\r?$").matcher(message);
        assertTrue(field.find(), () -> name + " of " + message);
        return field.group(1);
    }

    private static String tagOf(String value) {
        return value.replaceAll(".*;tag=", "");
    }

    String uri(String user) {
        return "sip:" + user + "@" + VirtualSip.HOST;
    }

    /** A request of this phone. @param more lines of the header, each with its end */
    String request(String method, String uri, String more, String body) {
        String to = method.equals("REGISTER") ? uri(number) : uri;
        return method + " " + uri + " SIP/2.0\n"
                + "Via: SIP/2.0/UDP 10.0.0.1:9999;rport;branch=z9hG4bK" + number + "-" + callId + "-"
                + (keepsBranch ? branch : ++branch) + "\n"
                + "Max-Forwards: 70\n"
                + "From: <" + uri(number) + ">;tag=" + fromTag + "\n"
                + "To: <" + to + ">" + (toTag.isEmpty() ? "" : ";tag=" + toTag) + "\n"
                + "Call-ID: " + callId + "\n"
                + "CSeq: " + cseq++ + " " + method + "\n"
                + "Contact: <sip:x" + number + "@" + signalling + ";ob>\n"
                + more
                + extra
                + "Content-Length: " + body.replace("\n", "\r\n").getBytes(StandardCharsets.UTF_8).length + "\n\n"
                + body;
    }

    /** Sends a request, again with credentials if it is asked for them, and returns the final response. */
    String ask(String method, String uri, String more, String body) {
        say(request(method, uri, more, body));
        String answer = finalResponse();
        if (!answer.startsWith("SIP/2.0 401")) {
            return answer;
        }
        acknowledge(method, uri, answer);
        say(request(method, uri, more + authorization(answer, method, uri), body));
        return finalResponse();
    }

    private void acknowledge(String method, String uri, String answer) {
        if (method.equals("INVITE")) {
            say("ACK " + uri + " SIP/2.0\nVia: " + field(answer, "Via") + "\nFrom: " + field(answer, "From") + "\nTo: "
                    + field(answer, "To") + "\nCall-ID: " + callId + "\nCSeq: " + (cseq - 1) + " ACK\n\n");
        }
    }

    String finalResponse() {
        String answer = expect("SIP/2.0");
        while (answer.startsWith("SIP/2.0 1")) {
            answer = expect("SIP/2.0");
        }
        return answer;
    }

    /** The field with the credentials for a challenge. */
    String authorization(String challenge, String method, String uri) {
        String asked = field(challenge, "WWW-Authenticate");
        String nonce = asked.replaceAll(".*nonce=\"([^\"]*)\".*", "$1");
        algorithm = asked.replaceAll(".*algorithm=([A-Z0-9-]*).*", "$1");
        nonceCount = 0;
        return authorizationBy(nonce, method, uri);
    }

    String authorizationBy(String nonce, String method, String uri) {
        String count = "%08x".formatted(++nonceCount);
        String first = hash(number + ":simgsm:" + password);
        String response = hash(first + ":" + nonce + ":" + count + ":cn:auth:" + hash(method + ":" + uri));
        return "Authorization: Digest username=\"" + number + "\", realm=\"simgsm\", nonce=\"" + nonce + "\", uri=\""
                + uri
                + "\", response=\"" + response + "\", algorithm=" + algorithm + ", cnonce=\"cn\", qop=auth, nc=" + count
                + "\n";
    }

    private String hash(String text) {
        try {
            byte[] octets = MessageDigest.getInstance(algorithm).digest(text.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(octets);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError(e);
        }
    }

    VirtualSipPhone registered() {
        String answer = register("Expires: 600\n");
        assertTrue(answer.startsWith("SIP/2.0 200"), answer);
        return this;
    }

    String register(String more) {
        return ask("REGISTER", "sip:" + VirtualSip.HOST, more, "");
    }

    String description() {
        return "v=0\no=- 1 1 IN IP4 198.51.100.9\ns=-\nc=IN IP4 " + speech.host() + "\nt=0 0\nm=audio " + speech.port()
                + " RTP/AVP 8 0 " + eventType + "\na=rtpmap:8 PCMA/8000\na=rtpmap:" + eventType
                + " telephone-event/8000\na=fmtp:" + eventType + " 0-16\n";
    }

    static final String SDP = "Content-Type: application/sdp\n";

    /** Calls a number and waits for the answer, which is acknowledged. */
    String call(String called) {
        beginCall();
        String answer = ask("INVITE", uri(called), SDP, description());
        if (answer.startsWith("SIP/2.0 200")) {
            established(answer, called);
        }
        return answer;
    }

    void beginCall() {
        callId = "call" + branch;
        toTag = "";
        cseq = 1;
    }

    void established(String answer, String called) {
        toTag = tagOf(field(answer, "To"));
        media(answer);
        ack(called, Integer.parseInt(field(answer, "CSeq").split(" ")[0]));
    }

    void media(String description) {
        mediaPort = Integer.parseInt(description.replaceAll("(?s).*m=audio ([0-9]+) .*", "$1"));
    }

    void ack(String called, int number) {
        int next = cseq;
        cseq = number;
        say(request("ACK", uri(called), "", ""));
        cseq = next;
    }

    private void send(int type, boolean isMarked, int time, byte[] payload) {
        sip.toMedia(
                mediaPort,
                ByteBuffer.allocate(12 + payload.length)
                        .put((byte) 0x80)
                        .put((byte) (type | (isMarked ? 0x80 : 0)))
                        .putShort((short) sequence++)
                        .putInt(time)
                        .putInt(7)
                        .put(payload)
                        .array(),
                speech);
    }

    /** Gives the events sequence numbers of their own, and the sound its old ones again. */
    void numberApart(boolean isApart) {
        sequence += isApart ? 10_000 : -10_000 - 24;
    }

    void sendRaw(byte[] octets) {
        sip.toMedia(mediaPort, octets, speech);
    }

    /** Sends 20 ms of sound. */
    void sound(short[] samples) {
        send(8, false, timestamp, G711.A_LAW.encode(samples));
        timestamp += 160;
        sip.suite.seconds(0.02);
    }

    /** Keys as sound, 100 ms each and as much again. */
    void soundKeys(String keys) {
        DtmfGenerator generator = new DtmfGenerator();
        DtmfKey.sequence(keys).forEach(generator::enqueue);
        while (!generator.isIdle()) {
            short[] frame = new short[160];
            generator.read(frame);
            sound(frame);
        }
    }

    /** Keys as events: 5 packets of 20 ms, the end three times; 40 ms of silence after it. */
    void eventKeys(String keys) {
        for (DtmfKey key : DtmfKey.sequence(keys)) {
            int code = "0123456789*#ABCD".indexOf(key.symbol());
            int time = timestamp;
            for (int i = 1; i <= 5; i++) {
                event(code, false, i * 160, time, i == 1);
                sip.suite.seconds(0.02);
            }
            for (int i = 0; i < 3; i++) {
                event(code, true, 800, time, false);
            }
            sip.suite.seconds(0.04);
            timestamp = time + 1200;
        }
    }

    void event(int code, boolean isEnd, int duration, int time, boolean isMarked) {
        byte[] payload = {(byte) code, (byte) (isEnd ? 0x8a : 0x0a), (byte) (duration >> 8), (byte) duration};
        send(eventType, isMarked, time, payload);
    }

    void infoKeys(String type, String keys) {
        for (char key : keys.toCharArray()) {
            String body = type.endsWith("relay") ? "Signal=" + key + "\nDuration=160" : String.valueOf(key);
            say(request("INFO", uri(VirtualSuite.ROBOT), "Content-Type: " + type + "\n", body));
        }
    }

    Optional<String> poll(String beginning) {
        return received.stream()
                .filter(message -> message.startsWith(beginning))
                .findFirst();
    }
}
