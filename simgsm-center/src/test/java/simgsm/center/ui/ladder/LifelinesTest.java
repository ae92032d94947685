package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

    @ParameterizedTest
    @CsvSource({"2, 390, 84", "5, 610, 96", "5, 900, 200", "7, 670, 96", "7, 730, 120", "7, 1400, 240", "7, 2400, 250"})
    void theNamesBesideTheCenterHaveMoreRoomThanTheOuterLines(int terminals, int width, int room) {
        Lifelines lifelines = Lifelines.of(
                IntStream.range(0, terminals).mapToObj(i -> "555010" + i).toList());
        double center = lifelines.x("M3", width);
        for (boolean isLeft : new boolean[] {true, false}) {
            Lifelines.Range names = lifelines.nameRoom(isLeft, width);
            assertTrue(names.right() - names.left() >= room, "room for names: " + names);
            if (terminals > 2) {
                assertEquals(center, isLeft ? names.right() : names.left());
            }
        }
        double before = 0;
        for (String name : lifelines.names()) {
            double x = lifelines.x(name, width);
            assertTrue(x - before >= 51.9, name + " at " + x + " after " + before);
            before = x;
        }
        assertTrue(before <= width - Lifelines.TAG_UNITS - 30, "last at " + before);
        assertTrue(lifelines.leastWidth() <= 670, "needs " + lifelines.leastWidth());
    }

    @Test
    void aLonelyCenterStandsInTheMiddle() {
        double x = Lifelines.NONE.x("M3", WIDTH);

        assertTrue(x > WIDTH / 3.0 && x < WIDTH * 2 / 3.0, "at " + x);
    }
}
