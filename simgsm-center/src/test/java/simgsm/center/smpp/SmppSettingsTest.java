package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.message;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.withReceipt;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;

/** What an application has of its own: the lines {@code id.SETTING=value}. */
class SmppSettingsTest extends SmppStage {
    /** @param lines of the applications "sender" and "receiver", besides their passwords */
    private void admit(String... lines) {
        Map<String, String> all = new LinkedHashMap<>(Map.of("sender", "", "receiver", ""));
        for (String line : lines) {
            all.put(line.substring(0, line.indexOf('=')), line.substring(line.indexOf('=') + 1));
        }
        network.server.admit(SmppUsers.only(all));
    }

    private static byte[] hex(String digits) {
        return HexFormat.of().parseHex(digits);
    }

    @ParameterizedTest
    @CsvSource({
        "gsm, 0, 1b65, €",
        "gsm, 1, 1b65, €",
        "gsm, 1, 11, _",
        "latin1, 0, e9, é",
        "latin1, 1, e9, é",
        "ascii, 0, 5f, _",
        "latin1, 8, 20ac, €",
        "latin1, 3, e9, é"
    })
    void theAlphabetSaysWhatDataCoding0And1Mean(String alphabet, int dataCoding, String octets, String text) {
        admit("sender.alphabet=" + alphabet);
        sender().submit(1, message("1", SERVICE, 0, dataCoding, hex(octets)));
        network.commit();
        assertEquals(text, network.center.messages().waiting().get(0).text());
    }

    @ParameterizedTest
    @CsvSource({
        "gsm, é, 0, 05",
        "latin1, é, 0, e9",
        "ascii, e, 0, 65",
        "ascii, é, 8, 00e9",
        "latin1, €, 8, 20ac",
        "latin1, 1é, 0, 31e9"
    })
    void anApplicationReceivesItsAlphabetOrUcs2(String alphabet, String text, int dataCoding, String octets) {
        admit("receiver.alphabet=" + alphabet);
        TestCenter.Application receiver = receiver(SERVICE);
        sender().submit(1, message("1", SERVICE, 0, 8, text.getBytes(StandardCharsets.UTF_16BE)));
        sender().submit(2, message("1", SERVICE, 0, 0, simgsm.sms.GsmAlphabet.encode(text)));
        network.commit();
        SmppMessage asUcs2 = receiver.all(SmppPdu.Message.class).get(0).message();
        assertEquals(8, asUcs2.dataCoding(), "what was sent as UCS-2 stays so");
        SmppMessage heard = receiver.all(SmppPdu.Message.class).get(1).message();
        assertEquals(dataCoding, heard.dataCoding());
        assertEquals(octets, heard.shortMessage().toString());
    }

    @Test
    void aLongTextThatNeedsUcs2ComesAsPayload() {
        admit("receiver.alphabet=ascii");
        TestCenter.Application receiver = receiver(SERVICE);
        sender().submit(1, message("1", SERVICE, 0, 0, simgsm.sms.GsmAlphabet.encode("é".repeat(160))));
        network.commit();
        SmppMessage heard = receiver.last(SmppPdu.Message.class).message();
        assertEquals(0, heard.shortMessage().length());
        assertEquals(320, heard.parameter(0x0424).orElseThrow().length());
    }

    @ParameterizedTest
    @CsvSource({"'', hello ..", "gsm, 'hello \u001be\u0004'", "latin1, hello .è", "ascii, hello .."})
    void aReceiptQuotesCharactersThatTheApplicationReadsRightly(String alphabet, String quoted) {
        admit(alphabet.isEmpty() ? "sender.window=100" : "sender.alphabet=" + alphabet);
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSCEIVER, "sender", "");
        sender.submit(1, withReceipt(message("1", SERVICE, 0, 8, "hello €è".getBytes(StandardCharsets.UTF_16BE))));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), SmppStatus.OK);
        network.commit();
        String text = textOf(sender.last(SmppPdu.Message.class));
        assertEquals(quoted, text.substring(text.indexOf("text:") + 5));
    }

    @Test
    void aReceiptQuotesTwentyCharactersAndNoHalfOnes() {
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = network.bound(SmppCommand.BIND_TRANSCEIVER, "sender", "");
        String text = "\uD83D\uDE00".repeat(25);
        sender.submit(1, withReceipt(message("1", SERVICE, 0, 8, text.getBytes(StandardCharsets.UTF_16BE))));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), SmppStatus.OK);
        network.commit();
        assertTrue(textOf(sender.last(SmppPdu.Message.class)).endsWith(" text:" + ".".repeat(20)));
    }

    @Test
    void theWindowLimitsWhatIsUnanswered() {
        admit("receiver.window=3");
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = sender();
        for (int i = 0; i < 10; i++) {
            sender.submit(i + 1, text("1", SERVICE, "x"));
        }
        network.commit();
        assertEquals(3, receiver.heard.size());
    }

    @Test
    void theRateHoldsForAnApplicationOfThisMachineToo() {
        admit("sender.rate=10");
        TestCenter.Application sender = sender();
        for (int i = 0; i < 11; i++) {
            sender.submit(i + 1, text("1", SERVICE, "x"));
        }
        assertEquals(
                SmppStatus.THROTTLED, sender.last(SmppPdu.MessageResponse.class).status());
        assertEquals(10, network.tickets.size());
        network.passSeconds(1);
        sender.submit(12, text("1", SERVICE, "x"));
        assertEquals(11, network.tickets.size());
    }

    @ParameterizedTest
    @CsvSource({"0x58, drop, 0", "0x58, retry, 1", "0x65, retry, 1", "0x65, drop, 0", "0x64, drop, 0"})
    void theRetryTableDecidesWhetherARefusedMessageIsSentAgain(String status, String word, int waiting) {
        admit("receiver.retry." + status + "=" + word);
        TestCenter.Application receiver = receiver(SERVICE);
        sender().submit(1, text("1", SERVICE, "x"));
        network.commit();
        receiver.answer(receiver.last(SmppPdu.Message.class), Integer.decode(status));
        assertEquals(waiting, network.center.waitingCount());
    }

    @ParameterizedTest
    @CsvSource({
        "sender.alphabet=utf8, 'sender.alphabet: expected gsm, latin1 or ascii, found \"utf8\"'",
        "sender.window=0, 'sender.window: expected a number of 1 to 10000, found \"0\"'",
        "sender.rate=fast, 'sender.rate: expected a number of 1 to 1000000, found \"fast\"'",
        "sender.retry.88=drop, 'sender.retry.88: expected retry.0x and a command_status, found \"retry.88\"'",
        "sender.retry.0x58=never, 'sender.retry.0x58: expected drop or retry, found \"never\"'",
        "sender.windw=3, 'sender.windw: expected numbers, alphabet, window, rate or retry.0xSTATUS, found windw'",
        "nobody.window=3, nobody.window: there is no line nobody=password"
    })
    void aLineThatIsWrongIsNamedWithWhatWasExpected(String line, String error) {
        IllegalArgumentException found = assertThrows(IllegalArgumentException.class, () -> admit(line));
        assertEquals(error, found.getMessage());
    }

    @Test
    void aSystemIdMayHaveDots() {
        network.server.admit(SmppUsers.only(Map.of("my.shop", "secret", "my.shop.window", "1")));
        TestCenter.Application application = network.open(true);
        assertEquals(SmppStatus.OK, bind(application, "my.shop", "secret"));
    }
}
