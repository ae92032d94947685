package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class LifelinesTest {
    private static final int WIDTH = 600;

    @Test
    void theCenterStandsInTheMiddleAndNumbersInOrder() {
        assertEquals(List.of("M3"), Lifelines.of(List.of()).names());
        assertEquals(List.of("5550100", "M3"), Lifelines.of(List.of("5550100")).names());
        assertEquals(
                List.of("5550100", "M3", "5550200"),
                Lifelines.of(List.of("5550200", "5550100")).names());
        assertEquals(
                List.of("1", "2", "M3", "3"),
                Lifelines.of(List.of("3", "1", "2")).names());
    }

    @Test
    void theLatestTerminalsWinWhenThereAreTooMany() {
        List<String> terminals =
                IntStream.rangeClosed(1, 9).mapToObj(String::valueOf).toList();

        List<String> names = Lifelines.of(terminals).names();

        assertEquals(Lifelines.MAX_TERMINALS + 1, names.size());
        assertTrue(names.contains("1") && !names.contains("9"), names.toString());
    }

    @Test
    void linesStandApartAndInsideTheWidth() {
        Lifelines lifelines = Lifelines.of(List.of("1", "2", "3"));
        double before = Lifelines.TIME_UNITS;
        for (String name : lifelines.names()) {
            double x = lifelines.x(name, WIDTH);
            assertTrue(x > before && x < WIDTH - Lifelines.TAG_UNITS, name + " at " + x);
            before = x;
        }
        assertEquals(-1, lifelines.x("4", WIDTH));
    }

    @Test
    void aLonelyCenterStandsInTheMiddle() {
        double x = Lifelines.NONE.x("M3", WIDTH);

        assertTrue(x > WIDTH / 3.0 && x < WIDTH * 2 / 3.0, "at " + x);
    }
}
