package simgsm.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.octets.OctetString;

/** PDUs of SMPP 3.4 from octets and to octets, and in a stream. */
class SmppCodecTest {
    private static final SmppAddress FROM = new SmppAddress(1, 1, "5550100");
    private static final SmppAddress TO = new SmppAddress(0, 1, "5550200");
    private static final OctetString TEXT = OctetString.ofHex("48656c6c6f");
    private static final List<Tlv> PARAMETERS = List.of(
            Tlv.ofTwoOctets(Tlv.SAR_REFERENCE, 0x1234),
            Tlv.ofOctet(Tlv.SAR_TOTAL, 2),
            Tlv.ofText(Tlv.RECEIPTED_MESSAGE_ID, "17"));
    private static final SmppMessage MESSAGE = new SmppMessage(
            "CMT", FROM, TO, 0x40, 0, 3, "000001000000000R", "261128120000000+", 1, 1, 8, 0, TEXT, PARAMETERS);

    static Stream<SmppPdu> pdus() {
        return Stream.of(
                new SmppPdu.Bind(SmppCommand.BIND_TRANSCEIVER, 1, "app", "secret", "VMA", 0x34, "555.*"),
                new SmppPdu.BindResponse(SmppCommand.BIND_TRANSCEIVER, SmppStatus.OK, 1, "SimGSM"),
                new SmppPdu.Message(SmppCommand.SUBMIT_SM, 2, MESSAGE),
                new SmppPdu.Message(SmppCommand.DELIVER_SM, 3, MESSAGE),
                new SmppPdu.Message(
                        SmppCommand.DATA_SM,
                        4,
                        SmppMessage.of(FROM, TO, 0, 0, 0, OctetString.of(new byte[0]), PARAMETERS)),
                new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, SmppStatus.OK, 2, "17"),
                new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, SmppStatus.QUEUE_FULL, 2, ""),
                new SmppPdu.MessageResponse(SmppCommand.DELIVER_SM, SmppStatus.TEMPORARY_APPLICATION_ERROR, 3, ""),
                new SmppPdu.SubmitMulti(
                        5, SmppMessage.of(FROM, SmppAddress.NONE, 0, 0, 0, TEXT, List.of()), List.of(TO, FROM)),
                new SmppPdu.SubmitMultiResponse(
                        SmppStatus.OK, 5, "18", List.of(new SmppPdu.Refused(TO, SmppStatus.INVALID_DESTINATION))),
                new SmppPdu.Query(6, "17", FROM),
                new SmppPdu.QueryResponse(SmppStatus.OK, 6, "17", "261128120000000+", 2, 0),
                new SmppPdu.Cancel(7, "", "17", FROM, TO),
                new SmppPdu.Replace(8, "17", FROM, "", "000001000000000R", 1, 0, TEXT),
                new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, 9),
                new SmppPdu.PlainResponse(SmppCommand.UNBIND, SmppStatus.OK, 10),
                new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_ID, 11));
    }

    @ParameterizedTest
    @MethodSource("pdus")
    void eachIsReadFromItsOctetsAndOutOfAStream(SmppPdu pdu) throws SmppViolation {
        byte[] octets = SmppCodec.encode(pdu);
        assertEquals(pdu, SmppCodec.decode(octets));

        SmppFramer framer = new SmppFramer();
        for (int at = 0; at < octets.length; at++) {
            assertFalse(framer.hasNext(), "after " + at + " octets");
            framer.accept(ByteBuffer.wrap(octets, at, 1));
        }
        framer.accept(ByteBuffer.wrap(octets));
        for (int i = 0; i < 2; i++) {
            assertTrue(framer.hasNext());
            assertEquals(pdu, framer.next());
        }
        assertFalse(framer.hasNext());
    }

    @ParameterizedTest
    @CsvSource({
        // an unknown command; generic_nack as a request
        "00000010 00000099 00000000 00000001, 3, GenericNack",
        "00000010 00000000 00000000 00000001, 3, GenericNack",
        // bind: a system_id that has no end in the PDU; interface_version 3.6; TON 9
        "00000012 00000009 00000000 00000001 6161, 2, BindResponse",
        "00000017 00000009 00000000 00000001 000000 36 000000, 13, BindResponse",
        "00000017 00000009 00000000 00000001 000000 34 090000, 13, BindResponse",
        // submit_sm: priority 4; replace_if_present 2; a predefined message
        "0000001f 00000004 00000000 00000001 00 000000 000000 000004 0000 00 00 0000, 6, MessageResponse",
        "00000021 00000004 00000000 00000001 00 000000 000000 000000 0000 00 02 00 00 00, 84, MessageResponse",
        "00000021 00000004 00000000 00000001 00 000000 000000 000000 0000 00 00 00 01 00, 99, MessageResponse",
        // submit_multi: no destination; a list; an unknown flag
        "00000015 00000021 00000000 00000001 00 000000 00, 51, SubmitMultiResponse",
        "00000016 00000021 00000000 00000001 00 000000 01 02, 52, SubmitMultiResponse",
        "00000016 00000021 00000000 00000001 00 000000 01 07, 64, SubmitMultiResponse"
    })
    void aWrongRequestIsRefusedByItsResponse(String hex, int status, String answer) {
        byte[] octets = OctetString.ofHex(hex.replace(" ", "")).toArray();

        SmppViolation violation = assertThrows(SmppViolation.class, () -> SmppCodec.decode(octets));

        assertEquals(status, violation.status(), violation.getMessage());
        SmppPdu.Response response = (SmppPdu.Response) violation.answer().orElseThrow();
        assertEquals(answer, response.getClass().getSimpleName());
        assertEquals(status, response.status());
        assertEquals(1, response.sequence());
    }

    @Test
    void anUnknownResponseHasNoAnswer() {
        byte[] octets = OctetString.ofHex("00000010800000990000000000000001").toArray();

        assertEquals(
                Optional.empty(),
                assertThrows(SmppViolation.class, () -> SmppCodec.decode(octets))
                        .answer());
    }

    @ParameterizedTest
    @CsvSource({"0000000f", "00011171", "ffffffff"})
    void aWrongLengthMakesTheStreamUnusable(String length) {
        SmppFramer framer = new SmppFramer();
        framer.accept(ByteBuffer.wrap(OctetString.ofHex(length).toArray()));

        SmppViolation violation = assertThrows(SmppViolation.class, framer::hasNext);

        assertEquals(SmppStatus.INVALID_COMMAND_LENGTH, violation.status());
        assertTrue(violation.getMessage().contains("expected 16 to 70000"), violation.getMessage());
    }

    @Test
    void theTextIsInOnePlace() throws SmppViolation {
        Tlv payload = new Tlv(Tlv.MESSAGE_PAYLOAD, TEXT);
        SmppMessage inPayload = SmppMessage.of(FROM, TO, 0x40, 0, 0, OctetString.of(new byte[0]), List.of(payload));
        assertEquals(TEXT, inPayload.content());
        assertTrue(inPayload.hasHeader());
        assertEquals(TEXT, MESSAGE.content());

        SmppMessage inBoth = SmppMessage.of(FROM, TO, 0, 0, 0, TEXT, List.of(payload));
        assertEquals(
                SmppStatus.OPTIONAL_PARAMETER_NOT_ALLOWED,
                assertThrows(SmppViolation.class, inBoth::content).status());
    }
}
