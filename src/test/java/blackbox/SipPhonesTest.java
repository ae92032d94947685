package blackbox;

import static blackbox.VirtualSipPhone.SDP;
import static blackbox.VirtualSipPhone.field;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Msisdn;
import simgsm.gateway.sip.SipPeer;

/** SIP phones as subscribers (spec/remote.md, 4), by raw datagrams with a clock moved by hand. */
class SipPhonesTest {
    private static final String NUMBER = "5550300";
    private static final String ORDER = "order robot=robot text=**#**20** verdict=accepted";

    private final VirtualSuite suite = new VirtualSuite();
    private final VirtualSip sip = new VirtualSip(suite);
    private final VirtualSipPhone phone = new VirtualSipPhone(sip, NUMBER);

    private VirtualSipPhone inCall() {
        phone.registered();
        String answer = phone.call(VirtualSuite.ROBOT);
        assertTrue(answer.startsWith("SIP/2.0 200"), answer);
        suite.seconds(0.5);
        return phone;
    }

    private List<String> orders() {
        return suite.robotLines("order");
    }

    // registrar

    @Test
    void aRegisteredPhoneIsASubscriberUntilItGoes() {
        String answer = phone.register("Expires: 600\n");
        assertTrue(answer.startsWith("SIP/2.0 200"), answer);
        assertEquals("<sip:x5550300@192.0.2.2:10300;ob>;expires=600", field(answer, "Contact"));
        assertEquals(List.of(NUMBER + " 192.0.2.2:10300 idle"), sip.users());
        assertTrue(suite.exchange().snapshot().subscribers().toString().contains(NUMBER));
        phone.register("Expires: 0\n");
        assertEquals(List.of("joined " + NUMBER, "left " + NUMBER), sip.told);
        suite.seconds(61);
        assertEquals(0, sip.server().users().size());
    }

    @Test
    void aRegistrationEndsAtItsTime() {
        phone.register("Expires: 60\n");
        suite.seconds(59);
        assertEquals(1, sip.users().size());
        suite.seconds(2);
        assertEquals(List.of("joined " + NUMBER, "left " + NUMBER), sip.told);
    }

    @Test
    void aNonceIsFreshInEachChallengeAndAnOldOneIsStale() {
        String uri = "sip:" + VirtualSip.HOST;
        phone.say(phone.request("REGISTER", uri, "", ""));
        String first = phone.finalResponse();
        String credentials = phone.authorization(first, "REGISTER", uri);
        phone.say(phone.request("REGISTER", uri, credentials, ""));
        assertTrue(phone.finalResponse().startsWith("SIP/2.0 200"));
        // the count goes on with the same nonce, which a phone may do
        String nonce = field(first, "WWW-Authenticate").replaceAll(".*nonce=\"([^\"]*)\".*", "$1");
        phone.say(phone.request("REGISTER", uri, phone.authorizationBy(nonce, "REGISTER", uri), ""));
        assertTrue(phone.finalResponse().startsWith("SIP/2.0 200"));
        phone.say(phone.request("REGISTER", uri, credentials, ""));
        String stale = phone.finalResponse();
        assertTrue(field(stale, "WWW-Authenticate").endsWith("stale=true"), stale);
        assertFalse(stale.contains(nonce), stale);
    }

    @Test
    void aPhoneThatDoesNotTakeMd5IsOfferedSha256() {
        String uri = "sip:" + VirtualSip.HOST;
        phone.say(phone.request("REGISTER", uri, "", ""));
        assertTrue(field(phone.finalResponse(), "WWW-Authenticate").contains("algorithm=MD5"));
        String answer = phone.register("");
        assertTrue(answer.startsWith("SIP/2.0 200"), answer);
        assertEquals("SHA-256", phone.algorithm);
    }

    /** diago 0.42.1 and sip 0.0.6 take a repeated answer for a second one. */
    @Test
    void anAnswerAfterSilenceOfTheLineIsNotRepeatedAtOnce() {
        VirtualSuite slow = new VirtualSuite(1500);
        VirtualSipPhone caller = new VirtualSipPhone(new VirtualSip(slow), "5550300");
        caller.registered();
        String answer = caller.call(VirtualSuite.ROBOT);
        assertTrue(answer.startsWith("SIP/2.0 200"), answer);
        slow.seconds(0.1);
        assertEquals(Optional.empty(), caller.poll("SIP/2.0 200"));
    }

    /** pyVoIP 1.6.8: the INVITE with credentials has the branch of the first, Call-IDs are those of its last start. */
    @Test
    void aCallIdOfAnEarlierStartAndABranchOfTwoInvitesAreNoRepetitions() {
        phone.registered();
        phone.keepsBranch = true;
        for (String start : List.of("a", "b")) {
            phone.fromTag = start;
            String answer = phone.call("5550200");
            assertTrue(answer.startsWith("SIP/2.0 200"), answer);
            assertEquals("MD5", phone.algorithm);
            phone.say(phone.request("BYE", phone.uri("5550200"), "", ""));
            suite.seconds(40);
            phone.received.clear();
        }
    }

    @Test
    void wrongPasswordsAreLimitedToTenAMinuteForEachAddress() {
        phone.password = "guess";
        for (int i = 0; i < 10; i++) {
            phone.callId = "guess" + i;
            assertTrue(phone.register("").startsWith("SIP/2.0 401"));
        }
        phone.password = VirtualSip.PASSWORD;
        assertTrue(phone.register("").startsWith("SIP/2.0 403 Forbidden: too many wrong passwords"));
        suite.seconds(61);
        phone.registered();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Expires: 30|423 Interval Too Brief",
                "Require: path|420 Bad Extension",
            })
    void aRegisterIsRefusedClearly(String line, String answer) {
        assertTrue(phone.register(line + "\n").startsWith("SIP/2.0 " + answer));
    }

    @Test
    void theTwoHundredAndFirstPhoneIsRefusedWithTheLimit() {
        for (int i = 0; i < 200; i++) {
            new VirtualSipPhone(sip, Integer.toString(5_550_310 + i)).registered();
        }
        String answer = phone.register("");
        assertTrue(answer.startsWith("SIP/2.0 503 Service Unavailable: at most 200 SIP users"), answer);
    }

    // calls and keys

    @ParameterizedTest
    @ValueSource(ints = {96, 101, 120})
    void keysByEventAreAnsweredWithThePhonesTypeAndDriveTheRobot(int type) {
        phone.eventType = type;
        inCall();
        assertTrue(phone.tones.contains('1'), phone.tones.toString());
        phone.eventKeys("**#**20**");
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
        assertTrue(phone.tones.containsAll(List.of('6', '3')), phone.tones.toString());
        assertEquals(List.of(NUMBER + " 192.0.2.2:10300 call"), sip.users());
        assertTrue(phone.ask("BYE", phone.uri("5550200"), "", "").startsWith("SIP/2.0 200"));
        suite.seconds(0.1);
        assertEquals(1, suite.robotLines("released robot=robot cause=16").size());
        assertEquals(List.of(), sip.openMedia);
    }

    @Test
    void theAnswerNamesThePhonesTypeAndKeysOnly() {
        phone.eventType = 96;
        phone.registered();
        String answer = phone.call(VirtualSuite.ROBOT);
        assertTrue(answer.contains("a=rtpmap:96 telephone-event/8000\r\na=fmtp:96 0-15\r\n"), answer);
        assertTrue(answer.contains(" RTP/AVP 8 96\r\n"), answer);
    }

    @ParameterizedTest
    @ValueSource(strings = {"application/dtmf-relay", "application/dtmf"})
    void keysByInfoDriveTheRobot(String type) {
        inCall();
        phone.infoKeys(type, "**#**20**");
        suite.seconds(4);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void keysAsSoundDriveTheRobot() {
        inCall();
        phone.soundKeys("**#**20**");
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void aKeyByEventAndByInfoIsOneKey() {
        inCall();
        for (char key : "**#**20**".toCharArray()) {
            phone.eventKeys(String.valueOf(key));
            phone.infoKeys("application/dtmf-relay", String.valueOf(key));
            suite.seconds(0.2);
        }
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void infoKeysKeepTheirOrderWhenOneIsLost() {
        inCall();
        phone.infoKeys("application/dtmf-relay", "**#**");
        String lost = phone.request("INFO", phone.uri("5550200"), "Content-Type: application/dtmf\n", "2");
        String next = phone.request("INFO", phone.uri("5550200"), "Content-Type: application/dtmf\n", "0");
        phone.say(next);
        suite.seconds(0.5);
        phone.say(lost);
        phone.say(next);
        phone.infoKeys("application/dtmf-relay", "**");
        suite.seconds(4);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void aRepeatedInviteIsOneCallAndTheAnswerIsRepeatedUntilAck() {
        phone.registered();
        phone.beginCall();
        String uri = phone.uri("5550200");
        phone.say(phone.request("INVITE", uri, SDP, phone.description()));
        String challenge = phone.finalResponse();
        String invite =
                phone.request("INVITE", uri, SDP + phone.authorization(challenge, "INVITE", uri), phone.description());
        phone.say(invite);
        phone.say(invite);
        String ok = phone.expect("SIP/2.0 200");
        suite.seconds(1.6);
        assertEquals(ok, phone.expect("SIP/2.0 200"));
        assertEquals(1, suite.robotLines("call robot").size());
        // no ACK for 32 s: BYE, and the robot stands
        phone.expect("BYE sip:x5550300@192.0.2.2:10300;ob SIP/2.0");
        assertEquals(1, suite.robotLines("released robot=robot cause=16").size());
        assertEquals(List.of(), sip.openMedia);
    }

    @Test
    void cancelEndsTheCallBeforeItsAnswer() {
        VirtualSuite slow = new VirtualSuite(10_000);
        VirtualSip its = new VirtualSip(slow);
        VirtualSipPhone caller = new VirtualSipPhone(its, NUMBER).registered();
        caller.beginCall();
        String uri = caller.uri("5550200");
        caller.say(caller.request("INVITE", uri, SDP, caller.description()));
        String challenge = caller.finalResponse();
        String invite = caller.request(
                "INVITE", uri, SDP + caller.authorization(challenge, "INVITE", uri), caller.description());
        caller.say(invite);
        caller.expect("SIP/2.0 180");
        caller.say("CANCEL " + uri + " SIP/2.0\nVia: " + field(invite, "Via") + "\nFrom: " + field(invite, "From")
                + "\nTo: " + field(invite, "To") + "\nCall-ID: " + field(invite, "Call-ID") + "\nCSeq: "
                + (caller.cseq - 1) + " CANCEL\n\n");
        caller.expect("SIP/2.0 200");
        caller.expect("SIP/2.0 487");
        slow.seconds(0.2);
        assertEquals(List.of(NUMBER + " 192.0.2.2:10300 idle"), its.users());
        assertEquals(List.of(), its.openMedia);
    }

    @Test
    void byeBeforeTheAnswerEndsTheCall() {
        VirtualSuite slow = new VirtualSuite(10_000);
        VirtualSip its = new VirtualSip(slow);
        VirtualSipPhone caller = new VirtualSipPhone(its, NUMBER).registered();
        caller.beginCall();
        String uri = caller.uri("5550200");
        caller.say(caller.request("INVITE", uri, SDP, caller.description()));
        String challenge = caller.finalResponse();
        caller.say(caller.request(
                "INVITE", uri, SDP + caller.authorization(challenge, "INVITE", uri), caller.description()));
        caller.toTag = field(caller.expect("SIP/2.0 180"), "To").replaceAll(".*;tag=", "");
        caller.say(caller.request("BYE", uri, "", ""));
        caller.expect("SIP/2.0 200");
        caller.expect("SIP/2.0 487");
        slow.seconds(0.2);
        assertEquals(List.of(NUMBER + " 192.0.2.2:10300 idle"), its.users());
    }

    @Test
    void holdSilencesThePhoneAndTheCallGoesOnWithAnotherType() {
        inCall();
        String held = phone.ask("INVITE", phone.uri("5550200"), SDP, phone.description() + "a=sendonly\n");
        assertTrue(held.contains("a=recvonly"), held);
        phone.ack("5550200", phone.cseq - 1);
        suite.seconds(0.1);
        int before = phone.heardPackets;
        suite.seconds(2);
        assertEquals(before, phone.heardPackets);
        phone.eventType = 97;
        String retrieved = phone.ask("INVITE", phone.uri("5550200"), SDP, phone.description());
        assertTrue(retrieved.contains("a=rtpmap:97 telephone-event/8000"), retrieved);
        phone.ack("5550200", phone.cseq - 1);
        phone.eventKeys("**#**20**");
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
        assertTrue(phone.heardPackets > before);
    }

    @Test
    void aPhoneThatFallsSilentLosesItsCallWithin14Seconds() {
        inCall();
        suite.seconds(14);
        assertEquals(1, suite.robotLines("released robot=robot cause=16").size());
        assertTrue(phone.poll("OPTIONS").isPresent());
        assertTrue(phone.poll("BYE").isPresent());
    }

    @Test
    void aPhoneThatGoesLosesItsCallAtOnce() {
        inCall();
        phone.callId = "other";
        phone.toTag = "";
        phone.register("Expires: 0\n");
        suite.seconds(0.1);
        assertEquals(1, suite.robotLines("released robot=robot cause=16").size());
    }

    @ParameterizedTest
    @CsvSource({"5550999,404", "none,404", "5550300,486"})
    void causesAreStatuses(String called, int status) {
        phone.registered();
        String answer = phone.call(called);
        assertTrue(answer.startsWith("SIP/2.0 " + status), answer);
    }

    @Test
    void aCallWithoutRegistrationIsForbidden() {
        String answer = phone.call(VirtualSuite.ROBOT);
        assertTrue(answer.startsWith("SIP/2.0 403 Forbidden: 5550300 is not registered"), answer);
    }

    @ParameterizedTest
    @ValueSource(strings = {"m=audio 4000 RTP/AVP 18", "m=audio 4000 RTP/SAVP 8", "m=video 4000 RTP/AVP 96"})
    void otherSpeechIsNotAcceptable(String media) {
        phone.registered();
        phone.beginCall();
        String answer =
                phone.ask("INVITE", phone.uri("5550200"), SDP, "v=0\nc=IN IP4 192.0.2.2\nt=0 0\n" + media + "\n");
        assertTrue(answer.startsWith("SIP/2.0 488"), answer);
        assertEquals(List.of(), sip.openMedia);
    }

    /** A name of hexadecimal letters was looked up for each packet, on the thread of all calls. */
    @ParameterizedTest
    @CsvSource({
        "IN IP4 192.0.2.2, 200",
        "IN IP4 255.255.255.255, 200",
        "IN IP6 ::1, 200",
        "IN IP6 ::ffff:192.0.2.2, 200",
        "IN IP4 256.0.2.2, 488",
        "IN IP4 192.0.2, 488",
        "IN IP4 192.0.2.2., 488",
        "IN IP4 face.cafe, 488",
    })
    void speechGoesToAnAddressAndNotToAName(String connection, int status) {
        phone.registered();
        phone.beginCall();
        String answer = phone.ask(
                "INVITE", phone.uri("5550200"), SDP, "v=0\nc=" + connection + "\nt=0 0\nm=audio 4000 RTP/AVP 8\n");
        assertTrue(answer.startsWith("SIP/2.0 " + status), answer);
    }

    @ParameterizedTest
    @CsvSource({
        "OPTIONS,200",
        "SUBSCRIBE,489",
        "PUBLISH,489",
        "REFER,405",
        "UPDATE,405",
        "IN,405",
        "BYE,481",
        "INFO,481"
    })
    void otherRequestsAreAnswered(String method, int status) {
        phone.say(phone.request(method, phone.uri("5550200"), "", ""));
        String answer = phone.finalResponse();
        assertTrue(answer.startsWith("SIP/2.0 " + status), answer);
    }

    // the network calls

    @Test
    void aCallToTheNumberRingsThePhone() {
        phone.registered();
        VirtualPhone caller = suite.phone("5550100");
        caller.dial(NUMBER);
        String invite = phone.expect("INVITE sip:x5550300@192.0.2.2:10300;ob SIP/2.0");
        assertTrue(field(invite, "From").startsWith("<sip:5550100@192.0.2.1:5060>;tag="), invite);
        answer(invite, "180 Ringing", "", "");
        answer(invite, "200 OK", "Contact: <sip:there@192.0.2.2:10300>\n" + SDP, phone.description());
        phone.expect("ACK sip:there@192.0.2.2:10300 SIP/2.0");
        suite.seconds(0.5);
        assertEquals(List.of(NUMBER + " 192.0.2.2:10300 call"), sip.users());
        phone.media(invite);
        phone.eventKeys("25");
        suite.seconds(0.5);
        assertEquals(List.of("2", "5"), caller.tones);
        caller.hangUp();
        String bye = phone.expect("BYE sip:there@192.0.2.2:10300 SIP/2.0");
        answer(bye, "200 OK", "", "");
        assertEquals(List.of(), sip.openMedia);
    }

    @ParameterizedTest
    @CsvSource({"486 Busy Here,17", "603 Decline,21", "404 Not Found,1", "480 Temporarily Unavailable,18"})
    void theCallerHearsWhyThePhoneRefuses(String refusal, int cause) {
        phone.registered();
        VirtualPhone caller = suite.phone("5550100");
        caller.dial(NUMBER);
        answer(phone.expect("INVITE"), refusal, "", "");
        phone.expect("ACK");
        suite.seconds(1);
        assertEquals(List.of(cause), caller.releaseCauses);
    }

    @Test
    void aCallerWhoHangsUpCancels() {
        phone.registered();
        VirtualPhone caller = suite.phone("5550100");
        caller.dial(NUMBER);
        String invite = phone.expect("INVITE");
        caller.hangUp();
        suite.seconds(0.1);
        assertTrue(phone.poll("CANCEL").isEmpty(), "before the first response there is nothing to cancel");
        answer(invite, "180 Ringing", "", "");
        answer(phone.expect("CANCEL"), "200 OK", "", "");
        answer(invite, "487 Request Terminated", "", "");
        phone.expect("ACK");
        assertEquals(List.of(), sip.openMedia);
    }

    private void answer(String request, String status, String more, String body) {
        StringBuilder text = new StringBuilder("SIP/2.0 " + status + "\n");
        List.of("Via", "From", "Call-ID", "CSeq")
                .forEach(name -> text.append(name + ": " + field(request, name)).append("\n"));
        text.append("To: " + field(request, "To") + ";tag=b1\n" + more + "\n" + body);
        phone.say(text.toString());
    }

    // messages

    @Test
    void messagesGoBothWaysAndAreAcceptedOnceTheNetworkHasThem() {
        phone.registered();
        phone.callId = "message";
        String taken =
                phone.ask("MESSAGE", phone.uri("5550200"), "Content-Type: text/plain;charset=UTF-8\n", "** #*0 **");
        assertTrue(taken.startsWith("SIP/2.0 202"), taken);
        String reply = phone.expect("MESSAGE sip:x5550300@192.0.2.2:10300;ob SIP/2.0");
        assertTrue(reply.contains("3 Done: #*0."), reply);
        assertTrue(field(reply, "From").startsWith("<sip:5550200@"), reply);
        answer(reply, "200 OK", "", "");
    }

    @Test
    void aMessageWaitsForThePhoneThatIsAway() {
        phone.registered();
        VirtualPhone other = suite.phone("5550100");
        phone.register("Expires: 0\n");
        other.station().sendMessage(new Msisdn(NUMBER), "while away");
        suite.seconds(1);
        assertTrue(phone.poll("MESSAGE").isEmpty());
        phone.register("");
        String message = phone.expect("MESSAGE");
        assertTrue(message.endsWith("while away"), message);
    }

    @Test
    void theNetworkKeepsAMessageUntilThePhoneHasIt() {
        phone.registered();
        suite.phone("5550100").station().sendMessage(new Msisdn(NUMBER), "kept");
        String message = phone.expect("MESSAGE");
        assertEquals(1, suite.exchange().snapshot().waiting());
        answer(message, "200 OK", "", "");
        suite.seconds(0.2);
        assertEquals(0, suite.exchange().snapshot().waiting());
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 400})
    void aMessageThatThePhoneDoesNotTakeComesAgainAfterItsRegistration(int length) {
        phone.registered();
        String text = "x".repeat(length);
        suite.phone("5550100").station().sendMessage(new Msisdn(NUMBER), text);
        answer(phone.expect("MESSAGE"), "480 Temporarily Unavailable", "", "");
        suite.seconds(60);
        assertTrue(phone.poll("MESSAGE").isEmpty());
        phone.register("");
        phone.expect("MESSAGE");
        // now there is no answer at all
        suite.seconds(100);
        phone.received.clear();
        phone.register("");
        String message = phone.expect("MESSAGE");
        assertTrue(message.endsWith("\r\n\r\n" + text), message);
        answer(message, "200 OK", "", "");
        suite.seconds(600);
        assertEquals(0, suite.exchange().snapshot().waiting());
        assertTrue(phone.poll("MESSAGE").isEmpty(), "once");
    }

    @ParameterizedTest
    @CsvSource({
        "application/im-iscomposing+xml,,200",
        "message/imdn+xml,deflate,200",
        "text/html,,415",
        "text/plain,deflate,415"
    })
    void reportsAreNoMessages(String type, String encoding, int status) {
        phone.registered();
        String answer = phone.ask(
                "MESSAGE",
                phone.uri("5550200"),
                "Content-Type: " + type + "\n" + (encoding == null ? "" : "Content-Encoding: " + encoding + "\n"),
                "** #*0 **");
        assertTrue(answer.startsWith("SIP/2.0 " + status), answer);
        suite.seconds(1);
        assertEquals(List.of(), orders());
    }

    // wrong peers, facts/sip.md 4

    @Test
    void compactAndFoldedHeadersAndFromWithoutBracketsAreRead() {
        phone.say("OPTIONS sip:5550200@192.0.2.1 SIP/2.0\nv: SIP/2.0/UDP 10.0.0.1:9;branch=z9hG4bKx;rport,\n"
                + " SIP/2.0/UDP 10.0.0.2\nf: sip:5550300@192.0.2.1;tag=t1\nt:\n sip:5550200@192.0.2.1\ni: c\n"
                + "CSeq: 1\n OPTIONS\nl:  0\n\n");
        String answer = phone.expect("SIP/2.0 200");
        assertEquals(
                "SIP/2.0/UDP 10.0.0.1:9;branch=z9hG4bKx;received=192.0.2.2;rport=10300", field(answer, "Via"), answer);
        assertTrue(field(answer, "To").startsWith("sip:5550200@192.0.2.1;tag="), answer);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "\n",
                "hello",
                "OPTIONS sip:a@b SIP/2.0",
                "SIP/2.0 999 x\n\n",
                "SIP/2.0 200 OK\nVia: SIP/2.0/UDP h;branch=1\nCSeq: 1 BYE\n\n",
                "BYE sip:a@b SIP/2.0\nVia: x\nFrom: <\nTo: >\nCall-ID: 1\nCSeq: 99999999999 BYE\n\n",
                "INVITE sip:a@b SIP/2.0\nContent-Length: 99\n\n",
                "ACK sip:a@b SIP/2.0\nVia: SIP/2.0/UDP h\nFrom: a\nTo: b\nCall-ID: 1\nCSeq: 1 ACK\n\n",
                "CANCEL sip:a@b SIP/2.0\nVia: SIP/2.0/UDP h\nFrom: a\nTo: b\nCall-ID: 1\nCSeq: 1 CANCEL\n\n"
            })
    void brokenDatagramsDoNoHarm(String text) {
        phone.say(text);
        sip.toServer(new byte[] {0, 1, 0, 0, 0x21, 0x12, (byte) 0xa4, 0x42}, phone.signalling);
        phone.received.clear();
        phone.registered();
    }

    @Test
    void stunAndRtcpOnTheSpeechPortAreNotSpeech() {
        inCall();
        phone.sendRaw(new byte[] {0, 1, 0, 0, 0x21, 0x12, (byte) 0xa4, 0x42, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
        phone.sendRaw(new byte[] {(byte) 0x80, (byte) 200, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        phone.sendRaw(new byte[] {(byte) 0x9f, 8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        phone.eventKeys("**#**20**");
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void eventsThatAreNumberedApartDoNotSilenceTheSound() {
        inCall();
        phone.soundKeys("**#");
        phone.numberApart(true);
        phone.eventKeys("**2");
        phone.numberApart(false);
        phone.soundKeys("0**");
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void speechGoesToWhereItComesFromAndAStrangerIsNotHeard() {
        inCall();
        suite.seconds(0.2);
        int before = phone.heardPackets;
        assertTrue(before > 0, "until the first packet the description counts");
        byte[] key = {(byte) 0x80, (byte) 0xe5, 0, 1, 0, 0, 0, 9, 0, 0, 0, 9, 5, (byte) 0x8a, 3, 32};
        sip.toMedia(sip.openMedia.get(0), key, new SipPeer("203.0.113.9", 1));
        phone.eventKeys("**#**20**");
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void anEndlessEventIsOneKeyAndFlashIsNone() {
        inCall();
        phone.event(16, true, 800, 5, true);
        for (int i = 1; i <= 700; i++) {
            phone.event(11, false, Math.min(0xffff, i * 160), 7000, i == 1);
            suite.seconds(0.02);
        }
        suite.seconds(1);
        assertEquals(List.of("keys robot=robot keys=#"), suite.robotLines("keys"));
    }

    @Test
    void aKeyLongerThanASegmentIsOneKey() {
        inCall();
        for (int i = 1; i <= 450; i++) {
            int time = 7000 + (i > 409 ? 0xffff : 0);
            phone.event(11, i == 450, i > 409 ? (i - 409) * 160 : Math.min(0xffff, i * 160), time, i == 1);
            suite.seconds(0.02);
        }
        suite.seconds(1);
        assertEquals(List.of("keys robot=robot keys=#"), suite.robotLines("keys"));
    }

    /** diago 0.42.1 sends so where it sends no sound. */
    @Test
    void keysWithOneTimeStampForAllAreKeysOfTheirOwn() {
        inCall();
        for (int code : new int[] {10, 10, 11, 10, 10, 2, 0, 10, 10}) {
            for (int i = 1; i <= 7; i++) {
                phone.event(code, i >= 5, Math.min(5, i) * 160, 0, i == 1);
                suite.seconds(0.02);
            }
            suite.seconds(0.15);
        }
        suite.seconds(3);
        assertEquals(List.of(ORDER), orders());
    }

    @Test
    void anEventWithoutItsEndAndItsReorderedCopiesAreOneKey() {
        inCall();
        for (int time : List.of(1000, 3000, 1000, 3000, 5000, 3000)) {
            phone.event(5, false, 160, time, true);
            suite.seconds(0.02);
        }
        suite.seconds(2);
        assertEquals(
                List.of("keys robot=robot keys=5", "keys robot=robot keys=5", "keys robot=robot keys=5"),
                suite.robotLines("keys"));
    }

    /** 5 % of all datagrams are lost in both directions: each call's order is exact, or it is not there. */
    @Test
    void noOrderIsWrongWhereDatagramsAreLost() {
        SplittableRandom random = new SplittableRandom(7);
        phone.eventType = 96;
        phone.registered();
        int exact = 0;
        for (int i = 0; i < 10; i++) {
            suite.robotLines.clear();
            sip.lose(() -> random.nextInt(20) == 0);
            phone.fromTag = "a" + i;
            phone.beginCall();
            lossyCall();
            sip.lose(() -> false);
            exact += orders().size();
            assertTrue(orders().isEmpty() || orders().equals(List.of(ORDER)), orders().toString());
            phone.say(phone.request("BYE", phone.uri("5550200"), "", ""));
            suite.seconds(40);
            phone.received.clear();
            phone.register("");
        }
        assertTrue(exact >= 9, exact + " of 10 orders");
    }

    /** The phone repeats its requests as its transactions demand. */
    private void lossyCall() {
        String uri = phone.uri("5550200");
        String challenge = repeated(phone.request("INVITE", uri, SDP, phone.description()));
        phone.say("ACK " + uri + " SIP/2.0\nVia: " + field(challenge, "Via") + "\nFrom: " + field(challenge, "From")
                + "\nTo: " + field(challenge, "To") + "\nCall-ID: " + phone.callId + "\nCSeq: 1 ACK\n\n");
        String ok = repeated(
                phone.request("INVITE", uri, SDP + phone.authorization(challenge, "INVITE", uri), phone.description()));
        if (ok.startsWith("SIP/2.0 200")) {
            phone.established(ok, "5550200");
            phone.established(ok, "5550200");
            suite.seconds(1);
            phone.eventKeys("**#**20**");
            suite.seconds(3);
        }
    }

    private String repeated(String request) {
        for (int i = 0; i < 60; i++) {
            if (i % 10 == 0) {
                phone.say(request);
            }
            suite.seconds(0.1);
            while (!phone.received.isEmpty()) {
                String next = phone.received.poll();
                if (next.startsWith("SIP/2.0") && !next.startsWith("SIP/2.0 1")) {
                    String number = field(request, "CSeq");
                    if (field(next, "CSeq").equals(number)) {
                        return next;
                    }
                }
            }
        }
        throw new AssertionError("no answer to " + request.getBytes(StandardCharsets.UTF_8).length + " octets");
    }
}
