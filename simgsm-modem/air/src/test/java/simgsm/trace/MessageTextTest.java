package simgsm.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.abis.RslMessageTest;
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
                "[transaction: 1, opened by the sender, calling: +491700000001, called: +491700000002,"
                        + " bearer capability: speech]",
                text.fields().toString());
    }

    @Test
    void aSupplementaryServiceIsReportedWithItsOperationAndText() {
        MessageText request = MessageText.ofLayer3(
                OctetString.ofHex("0b3b1c14a11202010102013b300a04010f0405aa180c36027f0100"), Direction.UPLINK);

        assertEquals("Register (processUnstructuredSS-Request)", request.name());
        assertEquals(
                "[send sequence number: 0, transaction: 0, opened by the sender, invoke: 1,"
                        + " operation: 59 processUnstructuredSS-Request, text: *100#, version: 0]",
                request.fields().toString());
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
                "bearer capability: speech, full rate preferred, versions FR3 FR2 FR1 HR3 HR1",
                fields.get(fields.size() - 1).toString());
        for (String withClassmark :
                List.of("0524710333198105f41234abcd", "06270703331981082926240000000071", "05013305f41234abcd")) {
            List<Field> said = MessageText.ofLayer3(OctetString.ofHex(withClassmark), Direction.UPLINK)
                    .fields();
            assertEquals(
                    "classmark: phase 2, power class 4",
                    said.get(said.size() - 1).toString());
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
    }

    @Test
    void aBrokenMessageSaysWhatIsWrong() {
        MessageText text = MessageText.ofLayer3(OctetString.ofHex("03352c45"), Direction.UPLINK);

        assertEquals("Start DTMF", text.name());
        assertEquals(
                "cause: 96 invalid mandatory information", text.fields().get(1).toString());
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
        for (RslMessageTest.Example example : RslMessageTest.examples()) {
            assertFalse(ofRsl(example.hex()).name().isEmpty());
        }
        MessageText paging = ofRsl("0c1501900e000c0829262400000000712800");
        assertEquals("Paging Command", paging.name());
        assertEquals(
                "[channel number: PCH/AGCH 0, paging group: 0, mobile identity: IMSI 262420000000017, channel needed: 00]",
                paging.fields().toString());
        assertEquals("Release Indication", ofRsl("020901410200").name());
        assertEquals("Channel Release", ofRsl("0201014102000b0003060d00").name());
    }

    private static MessageText ofRsl(String hex) {
        return MessageText.ofRsl(OctetString.ofHex(hex), Locale.ROOT);
    }
}
