package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static simgsm.center.smpp.SmppClient.message;
import static simgsm.center.smpp.SmppClient.with;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.smpp.Tlv;
import simgsm.sms.Concatenation;
import simgsm.sms.UserData;

/** SMPP's short messages to user parts and back. */
class MessageContentTest {
    private static byte[] hex(String digits) {
        return HexFormat.of().parseHex(digits);
    }

    private static List<UserData> parts(int esmClass, int dataCoding, byte[] octets) throws SmppViolation {
        return MessageContent.parts(message("1", "2", esmClass, dataCoding, octets), dataCoding, 9);
    }

    private static String joined(List<UserData> parts) {
        return parts.stream().map(UserData::text).collect(Collectors.joining());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 | 1b65 | €",
                "0 | 00410d1b3c | @A\r[",
                "1 | 48656c6c6f | Hello",
                "3 | 47 72 fc df 65 | Grüße",
                "3 | e7 | ç",
                "8 | 00e9 4e2d | é中"
            })
    void eachCodingBecomesTheTextThatItSays(int dataCoding, String octets, String text) throws SmppViolation {
        assertEquals(
                text.replace("\\r", "\r"),
                parts(0, dataCoding, hex(octets.replace(" ", ""))).get(0).text());
    }

    @ParameterizedTest
    @CsvSource({
        "0, 1b654142",
        "1, 414243",
        "3, 4772fcdf65",
        "3, e7e7",
        "4, 00ff1080",
        "2, 00ff",
        "8, 00e94e2d",
        "241, 414243",
        "245, 00ff"
    })
    void anotherApplicationGetsTheSameOctets(int dataCoding, String octets) throws SmppViolation {
        UserData part = parts(0, dataCoding, hex(octets)).get(0);
        MessageContent.Translated back = MessageContent.translate(part, dataCoding, Optional.empty());
        assertEquals(octets, back.octets().toString());
        assertEquals(dataCoding, back.dataCoding());
    }

    @Test
    void aHeaderStaysInFrontOfItsText() throws SmppViolation {
        byte[] octets = hex("0500032a0201" + "48656c6c6f");
        UserData part = parts(SmppMessage.HAS_HEADER, 0, octets).get(0);
        assertEquals("Hello", part.text());
        assertEquals(new Concatenation(42, 2, 1), part.concatenation().orElseThrow());
        MessageContent.Translated back = MessageContent.translate(part, 0, Optional.empty());
        assertArrayEquals(octets, back.octets().toArray());
        assertEquals(true, back.hasHeader());
    }

    @Test
    void sarParametersBecomeAHeader() throws SmppViolation {
        List<Tlv> sar = List.of(
                new Tlv(Tlv.SAR_REFERENCE, OctetString.ofHex("012a")),
                Tlv.ofOctet(Tlv.SAR_TOTAL, 3),
                Tlv.ofOctet(Tlv.SAR_PART, 2));
        SmppMessage message = with(message("1", "2", 0, 0, hex("41")), "", 0, sar);
        UserData part = MessageContent.parts(message, 0, 0).get(0);
        assertEquals(new Concatenation(0x12a, 3, 2), part.concatenation().orElseThrow());
        assertEquals("A", part.text());
    }

    @ParameterizedTest
    @CsvSource({
        "0, 160, 1",
        "0, 161, 2",
        "0, 306, 2",
        "0, 307, 3",
        "4, 140, 1",
        "4, 141, 2",
        "4, 268, 2",
        "4, 269, 3",
        "8, 140, 1",
        "8, 142, 2"
    })
    void textThatIsTooLongForOnePartIsSplit(int dataCoding, int octets, int parts) throws SmppViolation {
        byte[] text = "A".repeat(octets).getBytes(StandardCharsets.US_ASCII);
        SmppMessage message = with(
                message("1", "2", 0, dataCoding, new byte[0]),
                "",
                0,
                List.of(new Tlv(Tlv.MESSAGE_PAYLOAD, OctetString.of(text))));
        List<UserData> split = MessageContent.parts(message, dataCoding, 9);
        assertEquals(parts, split.size());
        if (parts > 1) {
            assertEquals(
                    new Concatenation(9, parts, parts),
                    split.get(parts - 1).concatenation().orElseThrow());
        }
        if (dataCoding == 0) {
            assertEquals("A".repeat(octets), joined(split));
        }
    }

    @Test
    void noPartEndsWithinACharacter() throws SmppViolation {
        byte[] euros = hex("1b65".repeat(120));
        assertEquals("€".repeat(120), joined(parts(0, 0, euros)));
        byte[] pairs = ("a" + "\ud83d\ude00".repeat(60)).getBytes(StandardCharsets.UTF_16BE);
        assertEquals("a" + "\ud83d\ude00".repeat(60), joined(parts(0, 8, pairs)));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 80, 0x45", "0, 5, 41, 0x45", "0, 8, 414141, 0x01", "64, 0, 0a41, 0x01", "64, 0, '', 0x01"})
    void whatNoMobileCanTakeIsRefused(int esmClass, int dataCoding, String octets, String status) {
        SmppViolation refused = assertThrows(SmppViolation.class, () -> parts(esmClass, dataCoding, hex(octets)));
        assertEquals(Integer.decode(status), refused.status());
    }

    @Test
    void aTextBehindAHeaderIsNeverSplit() {
        byte[] octets = hex("0500032a0201" + "41".repeat(154));
        SmppViolation refused = assertThrows(SmppViolation.class, () -> parts(SmppMessage.HAS_HEADER, 0, octets));
        assertEquals(SmppStatus.INVALID_MESSAGE_LENGTH, refused.status());
    }
}
