package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MotionOutcomeTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, Double.MAX_VALUE})
    void theAmountDoneIsZeroOrMore(double amountDone) {
        assertEquals(amountDone, new MotionOutcome(MotionOutcome.Ending.DONE, amountDone).amountDone());
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, Double.POSITIVE_INFINITY, Double.NaN})
    void anyOtherAmountIsRefused(double amountDone) {
        assertThrows(IllegalArgumentException.class, () -> new MotionOutcome(MotionOutcome.Ending.DONE, amountDone));
    }
}
