package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

public class CcmCodecTest {
    CcmCodecTest() {}

    public record Example(CcmMessage message, String hex) {}

    public static List<Example> examples() {
        return List.of(
                new Example(new CcmMessage.Ping(), "00"),
                new Example(new CcmMessage.Pong(), "01"),
                new Example(new CcmMessage.IdentityRequest(), "0401080107010201030104010501010100"),
                new Example(new CcmMessage.IdentityResponse("M2", "49"), "05" + "0004014d3200" + "000400343900"),
                new Example(
                        new CcmMessage.IdentityResponse("M1", "49", "1001/0/0"),
                        "05" + "000a08313030312f302f3000" + "0004014d3100" + "000400343900"),
                new Example(new CcmMessage.IdentityAcknowledge(), "06"));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyMessageIsWritten(Example example) {
        assertEquals(
                example.hex(),
                OctetString.of(CcmCodec.encode(example.message())).toString());
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyMessageIsReadBack(Example example) throws ProtocolViolation {
        assertEquals(example.message(), decode(example.hex()));
    }

    @Test
    void noMessageIsForgotten() {
        Set<Class<?>> shown =
                examples().stream().map(example -> example.message().getClass()).collect(Collectors.toSet());

        assertEquals(Set.of(CcmMessage.class.getPermittedSubclasses()), shown);
    }

    @Test
    void tagsThatWeDoNotNeedAreReadOver() throws ProtocolViolation {
        assertEquals(
                new CcmMessage.IdentityResponse("M1", ""), decode("05" + "000a03313030312f302f3000" + "0004014d3100"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "02", "ff", "0500", "050005014d31", "050000", "050004010d3100"})
    void brokenMessagesAreRefused(String hex) {
        assertThrows(ProtocolViolation.class, () -> decode(hex));
    }

    private static CcmMessage decode(String hex) throws ProtocolViolation {
        return CcmCodec.decode(OctetString.ofHex(hex).toArray());
    }
}
