package simgsm.cells.radio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.cells.town.Clutter;

/** Check values by hand from Hata's formulas and COST 231. */
class PathLossTest {
    @ParameterizedTest
    @CsvSource({
        // Hata: 69.55 + 26.16 log 900 - 13.82 log 30 - 0.016
        "900, 30, 1.5, URBAN, 126.4",
        "900, 30, 1.5, SUBURBAN, 116.5",
        "900, 30, 1.5, OPEN, 97.9",
        "900, 50, 1.5, URBAN, 123.3",
        "450, 30, 1.5, URBAN, 118.6",
        // COST 231
        "1800, 30, 1.5, URBAN, 136.2",
        "1800, 30, 1.5, METROPOLITAN, 139.2",
    })
    void theLossAtOneKilometreIsThatOfTheTables(
            double megahertz, double base, double mobile, Clutter surroundings, double decibels) {
        assertEquals(decibels, new PathLoss(megahertz, base, mobile, surroundings).decibels(1_000), 0.06);
    }

    @Test
    void tenTimesTheDistanceCosts35DecibelsFromATowerOf30Metres() {
        PathLoss loss = new PathLoss(900, 30, 1.5, Clutter.URBAN);

        assertEquals(35.2, loss.decibels(10_000) - loss.decibels(1_000), 0.05);
    }

    @Test
    void theLossNeverFallsBelowFreeSpaceNorWithDistance() {
        for (Clutter surroundings : Clutter.values()) {
            PathLoss loss = new PathLoss(900, 200, 1.5, surroundings);
            double last = 0;
            for (double metres = 1; metres < 50_000; metres *= 1.1) {
                double decibels = loss.decibels(metres);
                assertTrue(decibels >= last, surroundings + " at " + metres);
                // 20 log(4 pi d / wavelength)
                double freeSpace = 20 * Math.log10(4 * Math.PI * metres / (299.792458 / 900));
                assertTrue(metres < 10 || decibels >= freeSpace - 0.01, surroundings + " at " + metres);
                last = decibels;
            }
        }
    }
}
