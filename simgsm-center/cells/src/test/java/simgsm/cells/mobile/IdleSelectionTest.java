package simgsm.cells.mobile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The choice of a cell in idle mode, with a clock moved by hand in steps of 480 ms. */
class IdleSelectionTest {
    private static final CellParameters PLAIN = new CellParameters(1, -105, 0, 4, 0, 0, 20);
    private static final CellParameters OTHER_AREA = new CellParameters(2, -105, 0, 4, 0, 0, 20);
    /** Averages settle after this. */
    private static final int AVERAGED = 8;

    private final IdleSelection selection = new IdleSelection(2);
    private long now;

    /** Measures once; returns whether the cell has changed. */
    private boolean measure(CellParameters first, double firstDbm, CellParameters second, double secondDbm) {
        now += Mobile.PERIOD_NANOS;
        return selection.measured(now, new double[] {firstDbm, secondDbm}, new CellParameters[] {first, second});
    }

    /** The milliseconds until the cell changes; -1 if it does not within a minute. */
    private long changesAfterMillis(CellParameters first, double firstDbm, CellParameters second, double secondDbm) {
        long start = now;
        while (now - start < 60_000_000_000L) {
            if (measure(first, firstDbm, second, secondDbm)) {
                return (now - start) / 1_000_000;
            }
        }
        return -1;
    }

    private void settle(CellParameters first, double firstDbm, CellParameters second, double secondDbm) {
        for (int i = 0; i < AVERAGED; i++) {
            assertFalse(measure(first, firstDbm, second, secondDbm));
        }
    }

    @Test
    void theFirstMeasurementChoosesTheBestCellAtOnce() {
        assertTrue(measure(PLAIN, -80, PLAIN, -70));
        assertEquals(1, selection.serving());
        assertEquals(35, selection.c2(1), 1e-9);
    }

    @Test
    void noCellIsChosenWhoseC1IsNotPositive() {
        assertFalse(measure(PLAIN, -105, PLAIN, -110));
        assertEquals(IdleSelection.NONE, selection.serving());
    }

    @Test
    void aBetterCellIsTakenAfterItWasBetterForFiveSeconds() {
        measure(PLAIN, -70, PLAIN, -72);
        settle(PLAIN, -70, PLAIN, -72);
        // The averages of 8 cross in the third measurement, after 1.44 s; 5.28 s are the first whole periods above 5 s.
        assertEquals(1_440 + 5_280, changesAfterMillis(PLAIN, -74, PLAIN, -70));
    }

    @Test
    void measurementsAndTimesFromBeforeAConnectionDoNotCountAfterIt() {
        measure(PLAIN, -70, PLAIN, -72);
        settle(PLAIN, -70, PLAIN, -72);
        for (int i = 0; i < 9; i++) {
            assertFalse(measure(PLAIN, -74, PLAIN, -70));
        }
        now += 10_000_000_000L;
        selection.camp(0, now);
        assertEquals(480 + 5_280, changesAfterMillis(PLAIN, -74, PLAIN, -70));
    }

    @Test
    void theFiveSecondsBeginAnewWhenTheServingCellIsBetterBetween() {
        measure(PLAIN, -70, PLAIN, -80);
        settle(PLAIN, -70, PLAIN, -80);
        for (int round = 0; round < 3; round++) {
            for (int i = 0; i < 9; i++) {
                assertFalse(measure(PLAIN, -70, PLAIN, -60));
            }
            settle(PLAIN, -70, PLAIN, -80);
        }
    }

    @Test
    void intoAnotherAreaACellMustBeBetterByTheHysteresis() {
        measure(PLAIN, -70, OTHER_AREA, -80);
        settle(PLAIN, -70, OTHER_AREA, -80);
        assertEquals(-1, changesAfterMillis(PLAIN, -70, OTHER_AREA, -66));
        assertTrue(changesAfterMillis(PLAIN, -70, OTHER_AREA, -65.9) > 0);
    }

    /** The two exceptions of TS 45.008, 6.6.2, are not added: 5 dB, not 4 + 5. */
    @Test
    void withinFifteenSecondsOfAChangeAnotherAreaNeedsTheLargerOfTheTwoMargins() {
        measure(PLAIN, -70, PLAIN, -80);
        settle(PLAIN, -70, PLAIN, -80);
        assertTrue(changesAfterMillis(PLAIN, -80, PLAIN, -60) > 0);
        settle(OTHER_AREA, -64, PLAIN, -60);
        long changed = now;
        assertTrue(changesAfterMillis(OTHER_AREA, -54, PLAIN, -60) > 0);
        assertTrue(now - changed < 10_000_000_000L);
    }

    /** TS 45.005, 4.1.1: class 4 of GSM 900 has 33 dBm, class 1 of DCS 1800 30 dBm. */
    @ParameterizedTest
    @CsvSource({
        "100, 5, 0",
        "100, 3, 4",
        "100, 0, 6",
        "100, 19, 0",
        "600, 0, 0",
        "600, 5, 0",
        "600, 29, 6",
        "600, 31, 2"
    })
    void theHandsetLacksWhatTheLevelOfItsBandAsksAboveItsOutput(int arfcn, int level, int decibels) {
        assertEquals(decibels, MobilePower.missingDecibels(arfcn, level));
    }

    @ParameterizedTest
    @CsvSource({"100, 2, 5", "100, 14, 14", "600, 0, 0", "600, 14, 14", "600, 30, 0"})
    void anOrderedLevelIsUsedWithinThePowerClass(int arfcn, int ordered, int used) {
        assertEquals(used, MobilePower.used(arfcn, ordered));
    }

    @Test
    void withinFifteenSecondsOfAChangeTheWayBackNeedsFiveDecibelsMore() {
        measure(PLAIN, -70, PLAIN, -80);
        settle(PLAIN, -70, PLAIN, -80);
        assertTrue(changesAfterMillis(PLAIN, -80, PLAIN, -60) > 0);
        long changed = now;
        // Better by 4 dB at once, but the change waits until the 15 s are over, and 5 s more.
        settle(PLAIN, -60, PLAIN, -64);
        long wait = changesAfterMillis(PLAIN, -60, PLAIN, -64);
        assertTrue(now - changed >= 20_000_000_000L && now - changed < 21_000_000_000L, wait + " ms");
    }

    @Test
    void aCellWhoseC1IsNegativeForFiveSecondsIsLeft() {
        measure(PLAIN, -70, PLAIN, -110);
        settle(PLAIN, -70, PLAIN, -110);
        long millis = changesAfterMillis(PLAIN, -120, PLAIN, -110);
        assertEquals(IdleSelection.NONE, selection.serving());
        // Seven of eight measurements at -120 dBm bring the average below -105 dBm.
        assertEquals(6 * 480 + 5_280, millis);
    }

    @Test
    void aCellThatFailsIsReplacedAtOnce() {
        measure(PLAIN, -70, PLAIN, -90);
        assertTrue(measure(null, -200, PLAIN, -90));
        assertEquals(1, selection.serving());
    }

    @Test
    void theTemporaryOffsetCountsUntilThePenaltyTimeIsOver() {
        CellParameters fast = new CellParameters(1, -105, 0, 4, 20, 60, 40);
        assertEquals(105 - 70 + 20 - 60, fast.c2(-70, 39.9), 1e-9);
        assertEquals(105 - 70 + 20, fast.c2(-70, 40), 1e-9);
        CellParameters avoided = new CellParameters(1, -105, 0, 4, 20, 0, -1);
        assertEquals(105 - 70 - 20, avoided.c2(-70, 1_000), 1e-9);
    }

    @Test
    void aCellThatAsksForMorePowerThanAHandsetHasIsWorseByTheDifference() {
        assertEquals(105 - 70 - 6, new CellParameters(1, -105, 6, 4, 0, 0, 20).c1(-70), 1e-9);
    }

    @Test
    void aCellWithAPenaltyIsReachedOnlyAfterIt() {
        CellParameters penalised = new CellParameters(1, -105, 0, 4, 0, 60, 20);
        measure(PLAIN, -80, penalised, -60);
        assertEquals(0, selection.serving());
        long millis = changesAfterMillis(PLAIN, -80, penalised, -60);
        assertTrue(millis >= 25_000 && millis < 26_000, millis + " ms");
    }
}
