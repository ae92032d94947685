package simgsm.modem.at;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AtParametersTest {
    private static final AtResult INCORRECT = new AtResult.EquipmentError(CmeError.INCORRECT_PARAMETERS);

    @Test
    void parametersStandBetweenCommasWithOrWithoutQuotes() throws AtException {
        AtParameters parameters = AtParameters.of(" 12 ,, \"a,b\" ,name,\"\"");
        assertEquals(5, parameters.atMost(5).count());
        assertEquals(12, parameters.number(0, 0, 12));
        assertEquals(Optional.empty(), parameters.given(1));
        assertEquals("a,b", parameters.text(2));
        assertEquals(Optional.of("name"), parameters.given(3));
        assertEquals("", parameters.text(4));
        assertEquals("", parameters.text(5));
    }

    @Test
    void nothingIsNoParameterAndOneCommaIsTwo() throws AtException {
        assertEquals(0, AtParameters.of("").count());
        assertEquals(2, AtParameters.of(",").count());
    }

    @Test
    void aNumberThatIsLeftOutHasItsDefaultAndABadOneHasNot() throws AtException {
        AtParameters parameters = AtParameters.of(",x,999999999");
        assertEquals(7, parameters.number(0, 0, 9, 7));
        assertEquals(7, parameters.number(5, 0, 9, 7));
        assertEquals(999_999_999, parameters.number(2, 0, Integer.MAX_VALUE, 0));
        assertThrows(AtException.class, () -> parameters.number(1, 0, 9, 7));
        assertThrows(AtException.class, () -> parameters.number(0, 0, 9));
    }

    @ParameterizedTest
    @ValueSource(strings = {"2", "11", "-3", "+3", "3.0", "1234567890", "99999999999999999999", "\u0663"})
    void aNumberOutsideItsRangeIsRefused(String text) throws AtException {
        AtParameters parameters = AtParameters.of(text);
        assertEquals(
                INCORRECT,
                assertThrows(AtException.class, () -> parameters.number(0, 3, 10))
                        .result());
    }

    @ParameterizedTest
    @ValueSource(strings = {"\"", "\"a", "a\"b\"", "\"a\"b", "\"a\"\"b\"", "1,\"2"})
    void quotesThatDoNotPairAreRefused(String text) {
        assertEquals(
                INCORRECT,
                assertThrows(AtException.class, () -> AtParameters.of(text)).result());
    }

    @Test
    void aCommandMayRefuseInItsOwnWay() throws AtException {
        AtParameters parameters = AtParameters.of("1,2").refusing(AtResult.ERROR);
        assertEquals(
                AtResult.ERROR,
                assertThrows(AtException.class, () -> parameters.atMost(1)).result());
        assertEquals(
                "ERROR",
                assertThrows(AtException.class, () -> parameters.number(0, 2, 3))
                        .getMessage());
    }
}
