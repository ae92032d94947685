package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.message;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.withReceipt;

import java.io.ByteArrayOutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;

/** Each field of each request with a value that is none, and each response with its mandatory fields, octet by octet. */
class SmppFieldsTest extends SmppStage {
    /** The fields of a request in their order; a text ends with a zero, {@code xHH} is an octet, {@code -HEX} are octets. */
    private static byte[] pdu(SmppCommand command, String fields) {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        for (String field : fields.split(" ")) {
            if (field.startsWith("x") || field.startsWith("-")) {
                body.writeBytes(HexFormat.of().parseHex(field.substring(1)));
            } else {
                body.writeBytes((field.equals(".") ? "" : field).getBytes(StandardCharsets.ISO_8859_1));
                body.write(0);
            }
        }
        byte[] header = SmppCodec.encode(new SmppPdu.Plain(command, 9));
        header[3] = (byte) (header.length + body.size());
        ByteArrayOutputStream pdu = new ByteArrayOutputStream();
        pdu.writeBytes(header);
        pdu.writeBytes(body.toByteArray());
        return pdu.toByteArray();
    }

    private static int statusOf(byte[] response) {
        return Integer.parseUnsignedInt(HexFormat.of().formatHex(response, 8, 12), 16);
    }

    private static String bodyOf(byte[] response) {
        return HexFormat.of().formatHex(response, SmppCodec.HEADER_LENGTH, response.length);
    }

    @ParameterizedTest
    @CsvSource({
        // service_type, source, destination, esm_class, protocol_id, priority, schedule, validity, receipts, replace,
        // data_coding, default message, length, text
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x00",
        "SUBMIT_SM,    sixsix x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x15",
        "SUBMIT_SM,    . x07 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x48",
        "SUBMIT_SM,    . x01 x02 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x49",
        "SUBMIT_SM,    . x01 x01 muchTooLongAName x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x0a",
        "SUBMIT_SM,    . x01 x01 1 x07 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x50",
        "SUBMIT_SM,    . x01 x01 1 x01 x12 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x51",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 letters x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x0b",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x08 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x00",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x10 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x43",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x02 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x43",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x04 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x43",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x03 x00 x03 . . x12 x00 x00 x00 x01 -41, 0x00",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x04 . . x00 x00 x00 x00 x01 -41, 0x06",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 soon . x00 x00 x00 x00 x01 -41, 0x61",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . long x00 x00 x00 x00 x01 -41, 0x62",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x03 x00 x00 x00 x01 -41, 0x07",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x04 x00 x00 x00 x01 -41, 0x07",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x80 x00 x00 x00 x01 -41, 0x07",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x02 x00 x00 x01 -41, 0x54",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x09 x00 x01 -41, 0x104",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x05 x01 -41, 0x63",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 xff -41, 0x01",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41042400, 0xc0",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -4104240001, 0xc2",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -410424000142, 0xc1",
        "SUBMIT_SM,    . x01 x01 1, 0x02",
        "DATA_SM,      . x07 x01 1 x01 x01 5550300 x00 x00 x00 -0424000141, 0x48",
        "DATA_SM,      . x01 x01 1 x01 x02 5550300 x00 x00 x00 -0424000141, 0x51",
        "DATA_SM,      . x01 x01 1 x01 x01 letters x00 x00 x00 -0424000141, 0x0b",
        "DATA_SM,      . x01 x01 1 x01 x01 5550300 x02 x00 x00 -0424000141, 0x43",
        "DATA_SM,      . x01 x01 1 x01 x01 5550300 x00 x20 x00 -0424000141, 0x07",
        "DATA_SM,      . x01 x01 1 x01 x01 5550300 x00 x00 x0b -0424000141, 0x104",
        "SUBMIT_MULTI, . x07 x01 1 x01 x01 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x48",
        "SUBMIT_MULTI, . x01 x01 1 x01 x03 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x40",
        "SUBMIT_MULTI, . x01 x01 1 x01 x01 x01 x02 5550300 x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 0x51",
        "SUBMIT_MULTI, . x01 x01 1 x01 x01 x01 x01 5550300 x00 x00 x09 . . x00 x00 x00 x00 x01 -41, 0x06",
        "SUBMIT_MULTI, . x01 x01 1 x01 x01 x01 x01 5550300 x00 x00 x00 . . x00 x00 x00 x01 x01 -41, 0x63",
        "QUERY_SM,     999999 x01 x01 1, 0x67",
        "QUERY_SM,     1 x09 x01 1, 0x48",
        "QUERY_SM,     1 x01 x05 1, 0x49",
        "CANCEL_SM,    . 999999 x01 x01 1 x01 x01 5550300, 0x11",
        "CANCEL_SM,    . 1 x07 x01 1 x01 x01 5550300, 0x48",
        "CANCEL_SM,    sixsix 1 x01 x01 1 x01 x01 5550300, 0x15",
        "REPLACE_SM,   999999 x01 x01 1 . . x00 x00 x01 -41, 0x13",
        "REPLACE_SM,   1 x01 x05 1 . . x00 x00 x01 -41, 0x49",
        "REPLACE_SM,   1 x01 x01 1 soon . x00 x00 x01 -41, 0x61",
        "REPLACE_SM,   1 x01 x01 1 . . x03 x00 x01 -41, 0x07",
        "REPLACE_SM,   1 x01 x01 1 . . x00 x01 x01 -41, 0x63",
    })
    void aValueThatIsNoneIsRefusedByTheStatusThatNamesItsField(SmppCommand command, String fields, String status) {
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", "5550399", "waits as message 1"));
        network.commit();
        sender.say(pdu(command, fields));
        network.commit();
        assertEquals(Integer.decode(status), statusOf(sender.lastOctets));
    }

    @ParameterizedTest
    @CsvSource({
        "x34 x00 x00 ., 0x00",
        "x50 x00 x00 ., 0x00",
        "x33 x00 x00 ., 0x00",
        "x00 x00 x00 ., 0x00",
        "x35 x00 x00 ., 0x0d",
        "xff x00 x00 ., 0x0d",
        "x34 x07 x00 ., 0x0d",
        "x34 x00 x02 ., 0x0d",
        "x34 x00 x00 [1-, 0x0d",
    })
    void aBindWithAValueThatIsNoneIsRefused(String fields, String status) {
        TestCenter.Application application = network.open(true);
        application.say(pdu(SmppCommand.BIND_TRANSCEIVER, "id password type " + fields));
        assertEquals(Integer.decode(status), statusOf(application.lastOctets));
    }

    /** The message id is echoed, the final date empty, the state UNKNOWN; data_sm has no id, submit_multi names whom it misses. */
    @ParameterizedTest
    @CsvSource({
        "QUERY_SM,     999999 x01 x01 1, 39393939393900000700",
        "QUERY_SM,     999999, 00000700",
        "DATA_SM,      . x01 x01 1 x01 x01 letters x00 x00 x00 -0424000141, 00",
        "DATA_SM,      ., 00",
        "SUBMIT_MULTI, . x01 x01 1 x01 x01 x01 x01 bar x00 x00 x00 . . x00 x00 x00 x00 x01 -41, 00010101626172000000000b",
        "SUBMIT_MULTI, . x01 x01 1 x00, 0000",
        "SUBMIT_SM,    . x01 x01 1 x01 x01 letters x00 x00 x00 . . x00 x00 x00 x00 x01 -41, ''",
        "CANCEL_SM,    . 999999 x01 x01 1 x01 x01 1, ''",
        "REPLACE_SM,   999999 x01 x01 1 . . x00 x00 x01 -41, ''",
        "BIND_RECEIVER, again . . x34 x00 x00 ., ''",
        "BIND_TRANSMITTER, again . . x34 x00 x00 ., ''",
        "BIND_TRANSCEIVER, again . . x34 x00 x00 ., 000210000134"
    })
    void aResponseWithMandatoryFieldsHasThemOnAnErrorToo(SmppCommand command, String fields, String body) {
        TestCenter.Application sender = sender();
        sender.say(pdu(command, fields));
        assertFalse(statusOf(sender.lastOctets) == SmppStatus.OK);
        assertEquals(body, bodyOf(sender.lastOctets));
    }

    @Test
    void aMessageThatTheStoreDoesNotTakeHasNoId() {
        TestCenter.Application sender = sender();
        sender.say(pdu(SmppCommand.DATA_SM, ". x01 x01 1 x01 x01 5550300 x00 x00 x00 -0424000141"));
        network.center.committed(network.tickets.remove(), false);
        assertEquals(SmppStatus.SYSTEM_ERROR, statusOf(sender.lastOctets));
        assertEquals("00", bodyOf(sender.lastOctets));
    }

    @ParameterizedTest
    @CsvSource({"0x33, 0", "0x00, 0", "0x34, 1", "0x50, 1"})
    void onlyAnApplicationOfSmpp34GetsOptionalParameters(String version, int count) {
        TestCenter.Application application = network.open(true);
        application.say(
                new SmppPdu.Bind(SmppCommand.BIND_TRANSCEIVER, 1, "old", "", "", Integer.decode(version), SERVICE));
        assertEquals(count == 0 ? "53696d47534d00" : "53696d47534d000210000134", bodyOf(application.lastOctets));
        application.submit(2, withReceipt(text("1", SERVICE, "to itself")));
        network.commit();
        SmppPdu.Message delivery = application.last(SmppPdu.Message.class);
        assertEquals(count, delivery.message().parameters().size());
        application.answer(delivery, SmppStatus.OK);
        network.commit();
        SmppPdu.Message receipt = application.last(SmppPdu.Message.class);
        assertTrue(textOf(receipt).contains("stat:DELIVRD"));
        assertEquals(2 * count, receipt.message().parameters().size());
    }

    @Test
    void aTextThatNeedsAPayloadComesToAnOlderApplicationAsTheStandardCodesIt() {
        network.server.admit(SmppUsers.only(java.util.Map.of("old", "", "old.alphabet", "ascii", "sender", "")));
        TestCenter.Application old = network.open(true);
        old.say(new SmppPdu.Bind(SmppCommand.BIND_RECEIVER, 1, "old", "", "", 0x33, SERVICE));
        sender().submit(1, message("1", SERVICE, 0, 0, simgsm.sms.GsmAlphabet.encode("é".repeat(160))));
        network.commit();
        SmppPdu.Message delivery = old.last(SmppPdu.Message.class);
        assertEquals(0, delivery.message().dataCoding());
        assertEquals("05".repeat(160), delivery.message().shortMessage().toString());
    }

    @ParameterizedTest
    @CsvSource({
        "5, x-JIS0208, 日本",
        "6, ISO-8859-5, Привет",
        "7, ISO-8859-8, שלום",
        "13, JIS_X0212-1990, 丂丄",
        "14, EUC-KR, 안녕 ok"
    })
    void aFurtherAlphabetIsTranscodedToUcs2(int dataCoding, String charset, String text) {
        org.junit.jupiter.api.Assumptions.assumeTrue(Charset.isSupported(charset));
        TestCenter.Application receiver = receiver(SERVICE);
        TestCenter.Application sender = sender();
        sender.submit(1, message("1", SERVICE, 0, dataCoding, text.getBytes(Charset.forName(charset))));
        network.commit();
        assertEquals(SmppStatus.OK, statusOf(sender.lastOctets));
        assertEquals(
                List.of(text),
                network.center.messages().waiting().stream()
                        .map(each -> each.text())
                        .toList());
        SmppPdu.Message delivery = receiver.last(SmppPdu.Message.class);
        assertEquals(8, delivery.message().dataCoding());
        assertEquals(text, new String(delivery.message().shortMessage().toArray(), StandardCharsets.UTF_16BE));
    }

    @Test
    void octetsThatAnAlphabetDoesNotHaveAreRefused() {
        TestCenter.Application sender = sender();
        sender.submit(1, message("1", SERVICE, 0, 7, new byte[] {(byte) 0xa1}));
        assertEquals(SmppStatus.SUBMIT_FAILED, statusOf(sender.lastOctets));
    }
}
