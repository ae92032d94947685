package simgsm.center.bsc.handover;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simgsm.center.bsc.handover.HandoverDecision.Reason;
import simgsm.center.bsc.handover.HandoverDecision.Target;

class PowerBudgetDecisionTest {
    private static final NeighbourCell EAST = new NeighbourCell(110, 11);
    private static final NeighbourCell SOUTH = new NeighbourCell(120, 12);

    private final PowerBudgetDecision decision = new PowerBudgetDecision(PowerBudgetSettings.STANDARD);

    private Optional<Target> add(int number, int level, int quality, Measurement.Neighbour... neighbours) {
        decision.add(new Measurement(number, true, level, level, quality, 0, List.of(neighbours)));
        return decision.target();
    }

    private static Measurement.Neighbour east(int level) {
        return new Measurement.Neighbour(EAST, level);
    }

    private static Measurement.Neighbour south(int level) {
        return new Measurement.Neighbour(SOUTH, level);
    }

    /** As osmo-bsc 1.9 decided in a recorded run: reports 5 and 11 no, 17 yes. */
    @Test
    void aServingCellThatFallsAndANeighbourThatRisesCrossAtReport17() {
        List<Integer> handovers = IntStream.rangeClosed(0, 17)
                .filter(number ->
                        add(number, 50 - 2 * number, 0, east(15 + 2 * number)).isPresent())
                .boxed()
                .toList();

        assertEquals(List.of(17), handovers);
    }

    @Test
    void onlyEverySixthReportComparesWithTheNeighbours() {
        for (int number = 0; number < 5; number++) {
            assertEquals(Optional.empty(), add(number, 30, 0, east(50)));
        }
        assertEquals(Optional.of(new Target(EAST, Reason.POWER_BUDGET)), add(5, 30, 0, east(50)));
    }

    @Test
    void threeDecibelsAreEnoughAndTwoAreNot() {
        assertEquals(Optional.empty(), add(5, 30, 0, east(32)));
        add(10, 30, 0, east(34));
        assertEquals(Optional.of(new Target(EAST, Reason.POWER_BUDGET)), add(11, 30, 0, east(33)));
    }

    @Test
    void theBestNeighbourWinsAndTheFirstOfEqualOnes() {
        assertEquals(Optional.of(SOUTH), add(5, 30, 0, east(40), south(41)).map(Target::cell));
        assertEquals(Optional.of(EAST), add(11, 30, 0, east(41), south(40)).map(Target::cell));
    }

    @Test
    void aNeighbourThatIsMissingInAReportWithOthersCountsWithLevelZero() {
        add(0, 30, 0, east(40));
        add(1, 30, 0, south(1));
        assertEquals(Optional.empty(), add(5, 30, 0, south(1)));
    }

    @Test
    void aReportWithoutAnyNeighboursKeepsTheAverages() {
        add(0, 30, 0, east(40));
        add(1, 30, 0);
        assertEquals(Optional.of(EAST), add(5, 30, 0).map(Target::cell));
    }

    @Test
    void badQualityInThreeOfFourReportsActsAtOnce() {
        add(0, 50, 5, east(60));
        add(1, 50, 0, east(60));
        assertEquals(Optional.empty(), add(2, 50, 6, east(60)));
        assertEquals(Optional.of(new Target(EAST, Reason.INTERFERENCE)), add(3, 50, 7, east(60)));
    }

    @Test
    void badQualityAtALowAverageIsNoInterference() {
        for (int number = 0; number < 10; number++) {
            add(number % 5, 10, 0, east(13));
        }
        add(0, 10, 5, east(13));
        add(1, 10, 5, east(13));
        assertEquals(Optional.of(new Target(EAST, Reason.BAD_QUALITY)), add(2, 10, 5, east(13)));
    }

    @Test
    void anAverageOfMinus110DbmOrLessActsAtOnceAfterTenReports() {
        for (int number = 0; number < 9; number++) {
            assertEquals(Optional.empty(), add(number % 5, 0, 0, east(20)));
        }
        assertEquals(Optional.of(new Target(EAST, Reason.LOW_LEVEL)), add(0, 0, 0, east(20)));
    }

    @Test
    void aDistanceAboveTheMaximumActsAtOnce() {
        PowerBudgetDecision near =
                new PowerBudgetDecision(new PowerBudgetSettings(10, 10, 6, 3, 30, 5, 3, 4, -85, -110));
        near.add(new Measurement(0, true, 40, 40, 0, 31, List.of(east(50))));
        assertEquals(Optional.of(new Target(EAST, Reason.DISTANCE)), near.target());
    }

    @Test
    void theStrongestCellMovesAMobileAfterFourReportsInARow() {
        StrongestCellDecision strongest = new StrongestCellDecision(StrongestCellDecision.Settings.STANDARD);
        for (int level : new int[] {36, 36, 35, 36, 36, 36}) {
            strongest.add(new Measurement(0, true, 30, 30, 0, 0, List.of(east(level), south(20))));
            assertEquals(Optional.empty(), strongest.target());
        }
        strongest.add(new Measurement(0, true, 30, 30, 0, 0, List.of(south(20), east(37))));
        assertEquals(Optional.of(new Target(EAST, Reason.POWER_BUDGET)), strongest.target());
    }
}
