package simgsm.center.bsc.handover;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HandoverAlgorithmTest {
    private static final Measurement BETTER_BY_5 =
            new Measurement(1, true, 30, 30, 0, 0, List.of(new Measurement.Neighbour(new NeighbourCell(110, 11), 35)));

    private static boolean movesAtOnce(String text) {
        HandoverDecision decision = HandoverAlgorithm.of(text).decision();
        decision.add(BETTER_BY_5);
        return decision.target().isPresent();
    }

    @Test
    void theNumbersOfAnAlgorithmAreTaken() {
        assertEquals(false, movesAtOnce("power-budget"));
        assertEquals(true, movesAtOnce("power-budget,interval=2,hysteresis=5"));
        assertEquals(false, movesAtOnce("power-budget,interval=2,hysteresis=6"));
        assertEquals(false, movesAtOnce("strongest-cell,reports=1"));
        assertEquals(true, movesAtOnce("strongest-cell,reports=1,margin=5"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "best", "power-budget,margin=3", "power-budget,interval", "strongest-cell,reports=x"})
    void anotherTextIsRefusedWithWhatWasExpected(String text) {
        String message = assertThrows(IllegalArgumentException.class, () -> HandoverAlgorithm.of(text))
                .getMessage();
        assertTrue(message.startsWith("expected power-budget["), message);
    }

    @Test
    void aNumberOutOfItsRangeIsNamed() {
        assertEquals(
                "power budget interval 0 is not 1 to 99",
                assertThrows(IllegalArgumentException.class, () -> HandoverAlgorithm.of("power-budget,interval=0"))
                        .getMessage());
    }
}
