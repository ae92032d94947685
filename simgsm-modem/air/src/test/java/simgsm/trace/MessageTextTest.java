package simgsm.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.abis.RslCodecTest;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.Examples;
import simgsm.air.Examples.Example;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Type;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText.Field;

class MessageTextTest {
    static List<Example> examples() {
        return Examples.all();
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyMessageHasItsStandardNameAndItsOctets(Example example) {
        OctetString octets = OctetString.ofHex(example.hex());
        MessageText text = MessageText.ofLayer3(octets, example.direction());

        assertTrue(text.name().startsWith(Layer3Type.of(example.message()).title()), text.name());
        assertEquals(octets, text.octets());
        assertEquals(text.name(), MessageText.nameOf(example.message(), example.direction()));
    }

    @Test
    void aSetupIsReportedFieldByField() {
        MessageText text = MessageText.ofLayer3(
                OctetString.ofHex("13050401a05c0811819471000000105e0791947100000020"), Direction.DOWNLINK);

        assertEquals("Setup", text.name());
        assertEquals(
                List.of(
                        new Field("transaction", "1, opened by the sender"),
                        new Field("calling", "+491700000001"),
                        new Field("called", "+491700000002"),
                        new Field("bearer capability", "speech")),
                text.fields());
    }

    @Test
    void aSupplementaryServiceIsReportedWithItsOperationAndText() {
        MessageText request = MessageText.ofLayer3(
                OctetString.ofHex("0b3b1c14a11202010102013b300a04010f0405aa180c36027f0100"), Direction.UPLINK);

        assertEquals("Register (processUnstructuredSS-Request)", request.name());
        assertEquals(
                List.of(
                        new Field("send sequence number", "0"),
                        new Field("transaction", "0, opened by the sender"),
                        new Field("invoke", "1"),
                        new Field("operation", "59 processUnstructuredSS-Request"),
                        new Field("text", "*100#"),
                        new Field("version", "0")),
                request.fields());
        assertEquals(
                "Release Complete (error facility not supported)",
                MessageText.ofLayer3(OctetString.ofHex("8b2a1c08a306020101020115"), Direction.DOWNLINK)
                        .name());
    }

    @Test
    void whatAMobileCanDoIsReportedInWords() {
        List<Field> fields = MessageText.ofLayer3(
                        OctetString.ofHex("03050406600402000581" + "5e0791947100000020"), Direction.UPLINK)
                .fields();

        assertEquals(
                new Field("bearer capability", "speech, full rate preferred, versions FR3 FR2 FR1 HR3 HR1"),
                fields.get(fields.size() - 1));
        for (String withClassmark :
                List.of("0524710333198105f41234abcd", "06270703331981082926240000000071", "05013305f41234abcd")) {
            List<Field> said = MessageText.ofLayer3(OctetString.ofHex(withClassmark), Direction.UPLINK)
                    .fields();
            assertEquals(new Field("classmark", "phase 2, power class 4"), said.get(said.size() - 1));
        }
    }

    @Test
    void causesIdentitiesAndAreasAreReportedInWords() {
        assertEquals(
                "[send sequence number: 0, updating type: imsi attach, key sequence: 7, old area: 262/42 area 1,"
                        + " identity: IMSI 262420000000017, classmark: phase 2, power class 4]",
                MessageText.ofLayer3(OctetString.ofHex("05087262f224000133082926240000000071"), Direction.UPLINK)
                        .fields()
                        .toString());
        assertEquals(
                "[transaction: 0, opened by the receiver, cause: 16 normal call clearing, location: user]",
                MessageText.ofLayer3(OctetString.ofHex("832d0802e090"), Direction.DOWNLINK)
                        .fields()
                        .toString());
    }

    @ParameterizedTest
    @CsvSource({
        "UPLINK, 01, RP-DATA SUBMIT", "UPLINK, 00, RP-DATA DELIVER-REPORT", "UPLINK, 02, RP-DATA COMMAND",
        "DOWNLINK, 00, RP-DATA DELIVER", "DOWNLINK, 01, RP-DATA SUBMIT-REPORT", "DOWNLINK, 06, RP-DATA STATUS-REPORT",
        "UPLINK, 03, RP-DATA reserved"
    })
    void aShortMessageIsNamedByWhatItCarries(Direction direction, String tpdu, String name) {
        RelayMessage relay = new RelayMessage.RpData(1, Examples.SERVICE_CENTER, OctetString.ofHex(tpdu));
        OctetString octets = OctetString.of(
                Layer3Codec.encode(new ShortMessageControl.CpData(Examples.ours(0), relay), direction, 0));

        assertEquals(
                "CP-DATA (" + name + ")",
                MessageText.ofLayer3(octets, direction).name());
        assertEquals(Optional.of(OctetString.ofHex(tpdu)), MessageText.tpdu(octets, direction));
    }

    @Test
    void onlyRpDataHasATransferUnit() {
        assertEquals(Optional.empty(), MessageText.tpdu(OctetString.ofHex("8904"), Direction.DOWNLINK));
        assertEquals(Optional.empty(), MessageText.tpdu(OctetString.ofHex("89"), Direction.DOWNLINK));
    }

    @Test
    void aBrokenMessageSaysWhatIsWrong() {
        MessageText text = MessageText.ofLayer3(OctetString.ofHex("03352c45"), Direction.UPLINK);

        assertEquals("Start DTMF", text.name());
        assertEquals(
                new Field("cause", "96 invalid mandatory information"),
                text.fields().get(1));
        assertEquals(
                "unreadable message",
                MessageText.ofLayer3(OctetString.ofHex(""), Direction.UPLINK).name());
        assertEquals(
                "message type 0x3f of protocol 3",
                MessageText.ofLayer3(OctetString.ofHex("033f"), Direction.UPLINK)
                        .name());
    }

    @Test
    void radioLinkMessagesAreReportedByWhatTheyCarryOrByThemselves() {
        for (RslCodecTest.Example example : RslCodecTest.examples()) {
            MessageText text = MessageText.ofRsl(example.message());
            assertFalse(text.name().isEmpty());
        }
        MessageText paging = MessageText.ofRsl(new RslMessage.PagingCommand(Examples.IMSI));
        assertEquals("Paging Command", paging.name());
        assertEquals(List.of(new Field("identity", "IMSI 262420000000017")), paging.fields());
        assertEquals(
                "Release Indication",
                MessageText.ofRsl(new RslMessage.ReleaseIndication(RslMessage.Sapi.SIGNALLING))
                        .name());
        assertEquals(
                "Channel Release",
                MessageText.ofRsl(new RslMessage.DataRequest(RslMessage.Sapi.SIGNALLING, OctetString.ofHex("060d00")))
                        .name());
    }
}
