package simgsm.cells.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The words of the centre's {@code --handover}, as the town's window understands them. */
class HandoverRuleTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = ' ',
            value = {
                "power-budget 3 6 10",
                "power-budget,hysteresis=14,interval=1,neighbours=2 14 1 2",
                "power-budget,levels=4,distance=9 3 6 10",
                "strongest-cell 6 1 1",
                "strongest-cell,margin=9,reports=5 9 1 1"
            })
    void marginAndCountAreThoseOfTheController(String text, int margin, int period, int averaged) {
        assertEquals(new HandoverRule(margin, period, averaged), HandoverRule.parse(text));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "best", "power-budget,margin=3", "strongest-cell,reports=", "power-budget,hysteresis=-1"})
    void otherWordsAreRefused(String text) {
        String said = assertThrows(IllegalArgumentException.class, () -> HandoverRule.parse(text))
                .getMessage();
        assertTrue(said.endsWith("found " + text), said);
    }

    @Test
    void withoutAnOptionTheRuleIsThatOfOsmoBsc() {
        assertEquals(HandoverRule.parse("power-budget"), HandoverRule.STANDARD);
    }
}
