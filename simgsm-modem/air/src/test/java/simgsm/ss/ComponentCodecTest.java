package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.octets.OctetString;

class ComponentCodecTest {
    record Example(Component component, String hex) {}

    static List<Example> examples() {
        return List.of(
                new Example(
                        new Component.Invoke(
                                1,
                                SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST,
                                UssdText.of("*100#").encode()),
                        "a11202010102013b300a04010f0405aa180c3602"),
                new Example(
                        new Component.Invoke(0, SsOperation.INTERROGATE_SS, OctetString.ofHex("3003040121")),
                        "a10b02010002010e3003040121"),
                new Example(
                        new Component.ReturnResult(
                                1,
                                SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST,
                                UssdText.of("1").encode()),
                        "a210020101300b02013b300604010f040131"),
                new Example(new Component.ReturnResult(5), "a203020105"),
                new Example(new Component.ReturnError(1, SsError.UNEXPECTED_DATA_VALUE), "a306020101020124"),
                new Example(new Component.Reject(Optional.of(3), SsProblem.UNRECOGNIZED_OPERATION), "a406020103810101"),
                new Example(
                        new Component.Reject(Optional.empty(), SsProblem.BADLY_STRUCTURED_COMPONENT),
                        "a4050500800102"));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyComponentIsWrittenAndReadAsTheStandardHasIt(Example example) throws ComponentFault {
        OctetString octets = OctetString.ofHex(example.hex());

        assertEquals(octets, ComponentCodec.encode(example.component()));
        assertEquals(example.component(), ComponentCodec.decode(octets));
    }

    @Test
    void aLinkedIdentifierIsReadOver() throws ComponentFault {
        assertEquals(
                new Component.Invoke(2, SsOperation.UNSTRUCTURED_SS_REQUEST, Component.NONE),
                ComponentCodec.decode(OctetString.ofHex("a10902010280010102013c")));
    }

    @ParameterizedTest
    @CsvSource({
        "'', BADLY_STRUCTURED_COMPONENT, -1",
        "b1020500, UNRECOGNIZED_COMPONENT, -1",
        "a103020105, BADLY_STRUCTURED_COMPONENT, 5",
        "a106020181020124, BADLY_STRUCTURED_COMPONENT, -1",
        "a180020105, BADLY_STRUCTURED_COMPONENT, -1",
        "a1060201030401aa, BADLY_STRUCTURED_COMPONENT, 3",
        "a205020101040a, BADLY_STRUCTURED_COMPONENT, 1"
    })
    void aBrokenComponentIsRejectedWithItsProblem(String hex, SsProblem problem, int id) {
        ComponentFault fault =
                assertThrows(ComponentFault.class, () -> ComponentCodec.decode(OctetString.ofHex(hex)), hex);

        assertEquals(new Component.Reject(id < 0 ? Optional.empty() : Optional.of(id), problem), fault.answer());
    }

    @Test
    void spoiltComponentsGiveAComponentOrAFaultAndNothingElse() {
        Random random = new Random(2480);
        for (Example example : examples()) {
            for (int round = 0; round < 3000; round++) {
                byte[] octets = OctetString.ofHex(example.hex()).toArray();
                octets[random.nextInt(octets.length)] = (byte) random.nextInt(256);
                octets[random.nextInt(octets.length)] = (byte) random.nextInt(256);
                try {
                    Component read = ComponentCodec.decode(OctetString.of(octets));
                    assertEquals(read, ComponentCodec.decode(ComponentCodec.encode(read)));
                } catch (ComponentFault fault) {
                    ComponentCodec.encode(fault.answer());
                }
            }
        }
    }
}
