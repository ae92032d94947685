package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.ProtocolViolation;

class ServiceCodeTest {
    /** TS 22.030, annexes B and C. */
    @ParameterizedTest
    @CsvSource({
        "*#21#, INTERROGATE_SS, 3003040121",
        "*#43#, INTERROGATE_SS, 3003040141",
        "*43#, ACTIVATE_SS, 3003040141",
        "#43#, DEACTIVATE_SS, 3003040141",
        "##002#, ERASE_SS, 3003040120",
        "*21*5550200#, REGISTER_SS, 300a040121840581550502f0",
        "**61*+5550200*11*20#, REGISTER_SS, 301004012a830111840591550502f0850114",
        "*21*5550200*13#, REGISTER_SS, 300d040121830160840581550502f0",
        "*43*11#, ACTIVATE_SS, 3006040141830111",
        "##21**20#, ERASE_SS, 3006040121820100"
    })
    void aCodeOfASupplementaryServiceIsItsOperation(String typed, SsOperation operation, String argument) {
        Component.Invoke invoke = ServiceCode.invoke(1, typed);

        assertEquals(operation.code(), invoke.operation());
        assertEquals(argument, invoke.argument().toString());
    }

    @ParameterizedTest
    @CsvSource({"*100#", "*200*5550200#", "*111#", "1", "Hello", "**", "*#06*", "*12#"})
    void everyOtherTextIsUssd(String typed) throws ProtocolViolation {
        Component.Invoke invoke = ServiceCode.invoke(1, typed);

        assertEquals(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST.code(), invoke.operation());
        assertEquals(typed, UssdText.decode(invoke.argument()).text());
    }

    @Test
    void aTextThatIsTooLongIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> ServiceCode.invoke(1, "x".repeat(183)));
    }
}
