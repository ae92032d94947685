package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.answer.ProtocolErrorAnswers;
import simgsm.octets.OctetString;

/** What breaks its standard, the cause that says so, and what is answered. */
class RefusedMessagesTest {
    private static final int ACTIVE = 10;

    /** A number that cannot be dialled is the network's to refuse, with cause 28; the message itself is sound. */
    @ParameterizedTest
    @ValueSource(strings = {"03055e0291ba", "03055e0991214365870921436587"})
    void aCalledNumberThatIsNoTelephoneNumberIsLeftOut(String hex) throws ProtocolViolation {
        Layer3Message read = Layer3Codec.decode(HexFormat.of().parseHex(hex), Direction.UPLINK);

        assertEquals(
                Optional.empty(),
                assertInstanceOf(CallControl.Setup.class, read).called());
    }

    @ParameterizedTest
    @CsvSource({
        // too short, foreign protocol, reserved transaction identifier, skip indicator
        "UPLINK, '', 111",
        "UPLINK, 03, 111",
        "UPLINK, 0801, 97",
        "UPLINK, 7308, 81",
        "UPLINK, f904, 81",
        "UPLINK, 1501, 111",
        "DOWNLINK, 160d00, 111",
        // message types that do not exist, or not this way
        "UPLINK, 033f, 97",
        "UPLINK, 0302, 97",
        "DOWNLINK, 0308, 97",
        "UPLINK, 0502, 97",
        "DOWNLINK, 0524, 97",
        "UPLINK, 0635, 97",
        "UPLINK, 0902, 97",
        // mandatory elements missing, cut or senseless
        "UPLINK, 03050406600402000581, 96",
        "UPLINK, 0305040660040200058, 96",
        "UPLINK, 030504, 96",
        "UPLINK, 03055e0791947100, 96",
        "UPLINK, 0335, 96",
        "UPLINK, 03352d35, 96",
        "UPLINK, 03352c45, 96",
        "UPLINK, 033d02e090, 96",
        "UPLINK, 033d01e0ca, 96",
        "DOWNLINK, 8303, 96",
        "DOWNLINK, 830303e288, 96",
        "UPLINK, 050873 62f2240001 33 082926240000000071, 96",
        "UPLINK, 050872 62f2240001 33 092926240000000071, 96",
        "UPLINK, 050872 6af2240001 33 082926240000000071, 96",
        "UPLINK, 050872 62f2240001 33 0829262400000000a1, 96",
        "UPLINK, 050872 62f2240001 33 082126240000000071, 96",
        "UPLINK, 050872 62f2240001 33 012f, 96",
        "UPLINK, 050872 62f2240001 33 0121, 96",
        "UPLINK, 050872 62f2240001 33 00, 96",
        "UPLINK, 0524 73 03331981 05f41234abcd, 96",
        "UPLINK, 0524 71 03331981 05f412, 96",
        "UPLINK, 0519 08fa09512430325781, 96",
        "UPLINK, 0514a542, 96",
        "DOWNLINK, 0512 00 23, 96",
        "DOWNLINK, 051800, 96",
        "DOWNLINK, 051805, 96",
        "DOWNLINK, 0502 62f224, 96",
        "UPLINK, 0627 07 05331981, 96",
        "DOWNLINK, 060d, 96",
        "UPLINK, 0901, 96",
        "UPLINK, 090105, 96",
        "UPLINK, 09010100, 96",
        "UPLINK, 0910, 96",
        // elements that must be understood
        "DOWNLINK, 8301 0101ff, 96",
        "UPLINK, 8307 0000, 96",
        "UPLINK, 0305 5e0281f1 0500, 96",
        "DOWNLINK, 0521 0100, 96",
        // RP messages inside a sound CP-DATA
        "UPLINK, 0901020701, 97",
        "UPLINK, 0901020300, 97",
        "DOWNLINK, 0901020600, 97",
        "UPLINK, 090105 0001000000, 96",
        "UPLINK, 090107 0001000291 2100, 96",
    })
    void theCauseSaysWhatIsWrong(Direction direction, String hex, int cause) {
        ProtocolViolation violation = refused(hex, direction);

        assertEquals(cause, violation.statusCause().code(), violation.getMessage());
    }

    @ParameterizedTest
    @CsvSource({
        "UPLINK, 8301 7f0a01, 'an unknown element that is cut counts as absent'",
        "UPLINK, 8301 7f, 'and so does one without a length'",
        "UPLINK, 8301 91a2b3, 'one-octet elements are skipped'",
        "UPLINK, 8301 1e02ea81 7e0500, 'elements that we do not need are skipped'",
        "UPLINK, 8308 0406600402000581 15020100, 'a bearer capability may stand in CALL CONFIRMED'",
        "UPLINK, 832502, 'a DISCONNECT clears though its cause is cut'",
        "UPLINK, 832d08, 'a RELEASE clears though its cause is cut'",
        "UPLINK, 832a0101, 'a RELEASE COMPLETE clears whatever it holds'",
        "UPLINK, 033d03608090ca, 'a cause may have an extension octet'",
        "DOWNLINK, 0502 62f2240001 17020b00, 'a new identity that is none counts as absent'",
        "DOWNLINK, 0532 4301 80 47 62111221000040 4611 450186, 'time and zone have no length'",
        "DOWNLINK, 0512 00 23553cbe9637a89d218ae64dae47bf35 20021234, 'an AUTN of another length counts as absent'",
        "UPLINK, 0514 a54211d5 210d00112233445566778899aabbcc, 'and a RES longer than 16'",
        "DOWNLINK, 060d00 73050102030405, 'CHANNEL RELEASE may say more'",
        "UPLINK, 090107 0201 4102 0000 ff, 'octets behind an RP-ACK are no harm'",
    })
    void whatCanBeUnderstoodIsTaken(Direction direction, String hex, String why) {
        Layer3Message message = assertDecodes(hex, direction, why);

        assertEquals(direction, Layer3Type.of(message).goes(direction) ? direction : null, why);
    }

    @Test
    void aRefusedSetupIsReleased() {
        assertEquals(
                List.of(new CallControl.ReleaseComplete(
                        Examples.theirs(2),
                        Optional.of(Cause.INVALID_MANDATORY_INFORMATION),
                        Optional.of(CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER))),
                ProtocolErrorAnswers.to(refused("2305", Direction.UPLINK), 0));
    }

    @Test
    void anyOtherCallMessageIsAnsweredByStatus() {
        assertEquals(
                List.of(new CallControl.Status(Examples.theirs(0), Cause.MESSAGE_TYPE_NON_EXISTENT, ACTIVE)),
                ProtocolErrorAnswers.to(refused("0317", Direction.UPLINK), ACTIVE));
        assertEquals(
                List.of(new CallControl.Status(Examples.ours(0), Cause.INVALID_MANDATORY_INFORMATION, ACTIVE)),
                ProtocolErrorAnswers.to(refused("8303", Direction.DOWNLINK), ACTIVE));
    }

    @Test
    void requestsOfMobilityManagementAreRejectedByTheirOwnMessage() {
        assertEquals(
                List.of(new MobilityManagement.LocationUpdatingReject(RejectCause.INVALID_MANDATORY_INFORMATION)),
                ProtocolErrorAnswers.to(refused("0508", Direction.UPLINK), 0));
        assertEquals(
                List.of(new MobilityManagement.CmServiceReject(RejectCause.INVALID_MANDATORY_INFORMATION)),
                ProtocolErrorAnswers.to(refused("0524", Direction.UPLINK), 0));
        assertEquals(
                List.of(new MobilityManagement.MmStatus(RejectCause.MESSAGE_TYPE_NON_EXISTENT)),
                ProtocolErrorAnswers.to(refused("053e", Direction.UPLINK), 0));
    }

    @Test
    void radioResourceAnswersByRrStatus() {
        assertEquals(
                List.of(new RadioResource.RrStatus(97)),
                ProtocolErrorAnswers.to(refused("0634", Direction.DOWNLINK), 0));
    }

    @Test
    void aBrokenCpMessageIsAnsweredByCpError() {
        assertEquals(
                List.of(new ShortMessageControl.CpError(Examples.theirs(1), 97)),
                ProtocolErrorAnswers.to(refused("1977", Direction.UPLINK), 0));
    }

    @Test
    void aBrokenRpDataInASoundCpDataIsAcknowledgedAndRefused() {
        assertEquals(
                List.of(
                        new ShortMessageControl.CpAck(Examples.theirs(1)),
                        new ShortMessageControl.CpData(
                                Examples.theirs(1),
                                new RelayMessage.RpError(0x2a, RpCause.INVALID_MANDATORY_INFORMATION))),
                ProtocolErrorAnswers.to(refused("190105002a000000", Direction.UPLINK), 0));
    }

    /** TS 24.010, 4.2: there is no STATUS message. */
    @Test
    void aBrokenSupplementaryServiceMessageEndsItsDialogue() {
        assertEquals(
                List.of(new SupplementaryService.SsReleaseComplete(
                        Examples.theirs(1), Cause.INVALID_MANDATORY_INFORMATION)),
                ProtocolErrorAnswers.to(refused("1b3b", Direction.UPLINK), 0));
        assertEquals(
                List.of(new SupplementaryService.SsReleaseComplete(
                        Examples.theirs(1), Cause.MESSAGE_TYPE_NON_EXISTENT)),
                ProtocolErrorAnswers.to(refused("1b3c", Direction.UPLINK), 0));
    }

    @ParameterizedTest
    @CsvSource({
        "UPLINK, 033d",
        "UPLINK, 0531",
        "DOWNLINK, 0612",
        "UPLINK, 0910",
        "UPLINK, 7308",
        "UPLINK, 05",
        "UPLINK, 0801"
    })
    void errorReportsAndUnreadableHeadsAreNotAnswered(Direction direction, String hex) {
        assertEquals(List.of(), ProtocolErrorAnswers.to(refused(hex, direction), 0));
    }

    @Test
    void theTextNamesTheMessageAndWhatWasExpected() {
        String text = refused("03352c45", Direction.UPLINK).getMessage();

        assertEquals("Start DTMF: key 69 is none of 0-9 * # A-D", text);
    }

    private static ProtocolViolation refused(String hex, Direction direction) {
        byte[] octets = octets(hex);
        return assertThrows(ProtocolViolation.class, () -> Layer3Codec.decode(octets, direction), hex);
    }

    private static Layer3Message assertDecodes(String hex, Direction direction, String why) {
        try {
            return Layer3Codec.decode(octets(hex), direction);
        } catch (ProtocolViolation violation) {
            throw new AssertionError(why + ": " + violation.getMessage());
        }
    }

    private static byte[] octets(String hex) {
        String digits = hex.replace(" ", "");
        return OctetString.ofHex(digits.substring(0, digits.length() & ~1)).toArray();
    }
}
