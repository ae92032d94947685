package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.ChannelNumber;
import simgsm.air.ChannelNumber.Kind;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

class RslPduTest {
    /** As osmo-bsc 1.9 and a base station exchange them. */
    @ParameterizedTest
    @CsvSource({
        "0c1301881305123411 00, CHANNEL_REQUIRED",
        "082101200300060400030100050664204064720004000d0e18001f00, CHANNEL_ACTIVATION",
        "08220120080000, CHANNEL_ACTIVATION_ACKNOWLEDGE",
        "0c1601902b172d063f032040640512340000 2b2b2b2b2b2b2b2b2b2b2b, IMMEDIATE_ASSIGN_COMMAND",
        "02060120020 00b00020629, ESTABLISH_INDICATION",
        "030101200200 0b0003060d00, DATA_REQUEST",
        "02040120 0203, ESTABLISH_REQUEST",
        "030a0120 0240 0b0003063d00, UNIT_DATA_REQUEST",
        "0828010a 1b05 190300000004 00 2501, MEASUREMENT_RESULT",
        "08250120, DEACTIVATE_SACCH",
        "02070120 0203 1401, RELEASE_REQUEST",
        "082e0120, RF_CHANNEL_RELEASE",
        "7e70010af410f203, CREATE_CONNECTION",
        "7e71010af80001f57f000001f34e20, CREATE_CONNECTION_ACKNOWLEDGE",
        "7e73010af80001f07f000001f14e20f400f203, MODIFY_CONNECTION",
    })
    void theOctetsOfADialogueAreReadAndWrittenUnchanged(String hex, RslType type) throws ProtocolViolation {
        byte[] octets = OctetString.ofHex(hex.replace(" ", "")).toArray();

        RslPdu pdu = RslPdu.decode(octets);

        assertEquals(type, pdu.type());
        assertEquals(OctetString.of(octets), OctetString.of(pdu.encode()));
    }

    @Test
    void aChannelIsFoundByItsOctet() throws ProtocolViolation {
        assertEquals(new ChannelNumber(Kind.SDCCH_4, 2, 0), ChannelNumber.ofCode(0x30));
        assertEquals(ChannelNumber.of(Kind.TCH_F, 3), ChannelNumber.ofCode(0x0b));
        assertEquals(new ChannelNumber(Kind.SDCCH_8, 7, 1), ChannelNumber.ofCode(0x79));
        assertEquals(0x88, ChannelNumber.of(Kind.RACH, 0).code());
        assertThrows(ProtocolViolation.class, () -> ChannelNumber.ofCode(0x00));
        assertThrows(ProtocolViolation.class, () -> ChannelNumber.ofCode(0xc8));
    }

    @Test
    void aMessageThatIsCutOffOrUnknownIsRefused() {
        for (String hex : new String[] {"", "08", "0899", "0c130188130512", "02060120020 00b0005".replace(" ", "")}) {
            assertThrows(
                    ProtocolViolation.class,
                    () -> RslPdu.decode(OctetString.ofHex(hex).toArray()),
                    hex);
        }
    }

    @Test
    void theElementsOfMeasurementPreprocessingAreSkipped() throws ProtocolViolation {
        RslPdu pdu = RslPdu.decode(
                OctetString.ofHex("10600d0004001f37062026300a0a0c").toArray());

        assertEquals(RslPdu.of(RslType.MEASUREMENT_PREPROCESSING_DEFAULTS), pdu);
    }

    @Test
    void aMissingElementIsNamed() throws ProtocolViolation {
        RslPdu pdu = RslPdu.of(RslType.CHANNEL_REQUIRED);

        ProtocolViolation violation =
                assertThrows(ProtocolViolation.class, () -> pdu.value(RslElement.REQUEST_REFERENCE));

        assertEquals("RSL Channel Required without request reference", violation.getMessage());
    }
}
