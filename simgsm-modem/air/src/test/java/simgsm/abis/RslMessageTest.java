package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.RslMessage.BroadcastInformation;
import simgsm.abis.RslMessage.DataIndication;
import simgsm.abis.RslMessage.DataRequest;
import simgsm.abis.RslMessage.EncryptionCommand;
import simgsm.abis.RslMessage.ErrorIndication;
import simgsm.abis.RslMessage.EstablishIndication;
import simgsm.abis.RslMessage.MeasurementResult;
import simgsm.abis.RslMessage.PagingCommand;
import simgsm.abis.RslMessage.ReleaseIndication;
import simgsm.abis.RslMessage.Sapi;
import simgsm.abis.RslMessage.SmsBroadcastCommand;
import simgsm.air.Cause;
import simgsm.air.Examples;
import simgsm.air.ProtocolViolation;
import simgsm.air.Tmsi;
import simgsm.octets.OctetString;

public class RslMessageTest {
    RslMessageTest() {}

    public record Example(RslMessage message, String hex) {}

    private static final String PAGE = "401100320f11" + "d7".repeat(82);

    private static final String TYPE_3 = "49061b1b3a00f1100001c9033c3d6500af00002b2b2b2b";

    private static final String REPORT = "0615" + "1919" + "00".repeat(14);

    public static List<Example> examples() {
        return List.of(
                new Example(
                        new DataIndication(Sapi.SIGNALLING, OctetString.ofHex("05087262f224000133082926240000000071")),
                        "0302014102000b001205087262f224000133082926240000000071"),
                new Example(
                        new DataIndication(
                                Sapi.SHORT_MESSAGES,
                                OctetString.ofHex(
                                        "09011f00010007919471000000001331010c919471000000200000a705e8329bfd06")),
                        "0302014102030b002209011f00010007919471000000001331010c919471000000200000a705e8329bfd06"),
                new Example(
                        new EstablishIndication(Sapi.SIGNALLING, OctetString.ofHex("0308")), "0206014102000b00020308"),
                new Example(new DataRequest(Sapi.SIGNALLING, OctetString.ofHex("060d00")), "0301014102000b0003060d00"),
                new Example(new ReleaseIndication(Sapi.SHORT_MESSAGES), "020901410203"),
                new Example(new ErrorIndication(Sapi.SIGNALLING, 1), "020301410200160101"),
                new Example(
                        new BroadcastInformation(BroadcastInformation.TYPE_3, OctetString.ofHex(TYPE_3)),
                        "0c1101801e032717" + TYPE_3),
                new Example(
                        new MeasurementResult(17, OctetString.ofHex(REPORT)),
                        "082801411b111903000000" + "0400" + "0b0012" + REPORT),
                new Example(
                        new EncryptionCommand(OctetString.ofHex("02eae4be823af9a08b"), OctetString.ofHex("063501")),
                        "082601410709" + "02eae4be823af9a08b" + "0200" + "0b0003063501"),
                new Example(new PagingCommand(Examples.IMSI), "0c1501900e000c0829262400000000712800"),
                new Example(new PagingCommand(new Tmsi(0x1234abcd)), "0c1501900e000c05f41234abcd2800"),
                new Example(new SmsBroadcastCommand(OctetString.ofHex(PAGE)), "0c1d019029002a58" + PAGE));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyFormIsWritten(Example example) {
        assertEquals(example.hex(), OctetString.of(example.message().encode()).toString());
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyFormIsReadBack(Example example) throws ProtocolViolation {
        assertEquals(example.message(), decode(example.hex()));
    }

    @Test
    void noFormIsForgotten() {
        Set<Class<?>> shown =
                examples().stream().map(example -> example.message().getClass()).collect(Collectors.toSet());

        assertEquals(Set.of(RslMessage.class.getPermittedSubclasses()), shown);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "02",
                "0202",
                "020201",
                "0202014102000b",
                "0202014102000b0003060d",
                "0202014102000b0002060d00",
                "0202014102050b0003060d00",
                "0202024102000b0003060d00",
                "0c1501900e000c0029",
                "0c1501900e000c01f1",
                "0c1501900e000c09292624000000007111",
                "0c1d019029002a57" + "00"
            })
    void aBrokenFormIsInvalidMandatoryInformation(String hex) {
        ProtocolViolation violation = assertThrows(ProtocolViolation.class, () -> decode(hex));

        assertEquals(Cause.INVALID_MANDATORY_INFORMATION, violation.statusCause());
        assertTrue(violation.header().isEmpty());
    }

    @ParameterizedTest
    @ValueSource(strings = {"02ff01410200", "0c220190", "0422014102000b0003060d00"})
    void anUnknownFormIsANonExistentMessageType(String hex) {
        ProtocolViolation violation = assertThrows(ProtocolViolation.class, () -> decode(hex));

        assertEquals(Cause.MESSAGE_TYPE_NON_EXISTENT, violation.statusCause());
    }

    @Test
    void theSlowAssociatedChannelAndTheTransparentBitAreTheSameConversation() throws ProtocolViolation {
        assertEquals(
                new DataIndication(Sapi.SHORT_MESSAGES, OctetString.ofHex("0904")), decode("0302010a02430b00020904"));
    }

    @Test
    void aPageHas88Octets() {
        assertThrows(IllegalArgumentException.class, () -> new SmsBroadcastCommand(OctetString.ofHex("00")));
    }

    private static RslMessage decode(String hex) throws ProtocolViolation {
        return RslMessage.decode(OctetString.ofHex(hex).toArray());
    }
}
