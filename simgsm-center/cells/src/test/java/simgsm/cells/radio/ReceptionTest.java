package simgsm.cells.radio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownReader;

/** The scales of reports, what becomes of bits and frames, and the levels in a town. */
class ReceptionTest {
    @ParameterizedTest
    @CsvSource({"-140, 0", "-110, 0", "-109.5, 1", "-85, 25", "-84.3, 26", "-48, 62", "-47, 63", "10, 63"})
    void rxlevCountsDecibelsAbove110(double dbm, int rxlev) {
        assertEquals(rxlev, RadioScale.rxlev(dbm));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "0.0019, 0",
        "0.002, 1",
        "0.004, 2",
        "0.008, 3",
        "0.016, 4",
        "0.032, 5",
        "0.064, 6",
        "0.128, 7",
        "0.5, 7"
    })
    void rxqualBeginsAtTheRatesOfTheStandard(double bitErrorRate, int rxqual) {
        assertEquals(rxqual, RadioScale.rxqual(bitErrorRate));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "276, 0", "277, 1", "553.5, 1", "1107, 2", "34870, 63", "90000, 63"})
    void theTimingAdvanceHasStepsOf553Metres(double metres, int steps) {
        assertEquals(steps, RadioScale.timingAdvance(metres));
    }

    @Test
    void atTheReferenceLevelErrorsAreThoseOfTheStandard() {
        double carrier = ReceptionQuality.carrierDecibels(ReceptionQuality.REFERENCE_DBM, 0);
        double bitErrorRate = ReceptionQuality.bitErrorRate(carrier);

        assertEquals(9, carrier, 1e-9);
        assertEquals(0.08, bitErrorRate, 0.0005);
        assertEquals(0.06, ReceptionQuality.frameErasureRate(bitErrorRate), 0.001);
        assertEquals(0.13, ReceptionQuality.blockErasureRate(bitErrorRate), 0.001);
    }

    @Test
    void errorsOnlyGrowWhileTheLevelFalls() {
        double last = 0;
        double lastFrames = 0;
        for (double dbm = -40; dbm > -140; dbm -= 0.5) {
            double errors = ReceptionQuality.bitErrorRate(ReceptionQuality.carrierDecibels(dbm, 0));
            double frames = ReceptionQuality.frameErasureRate(errors);
            assertTrue(errors > last && frames >= lastFrames, dbm + " dBm");
            last = errors;
            lastFrames = frames;
        }
        assertEquals(0.5, last, 0.05);
        assertEquals(1, lastFrames);
    }

    @Test
    void goodReceptionLosesNoFrame() {
        double errors = ReceptionQuality.bitErrorRate(ReceptionQuality.carrierDecibels(-85, 0));

        assertEquals(0, ReceptionQuality.frameErasureRate(errors));
        assertTrue(RadioScale.rxqual(errors) <= 1);
    }

    private static Town town(String further) throws Exception {
        return TownReader.read("t.town", """
                shadow 0
                tower A 0 0 arfcn=20 bsic=1 lac=1
                tower B 4000 0 arfcn=20 bsic=2 lac=1
                tower C 4000 0 arfcn=21 bsic=3 lac=1
                tower D 4000 0 arfcn=23 bsic=4 lac=1
                """ + further);
    }

    @Test
    void theSameChannelDisturbsFullyTheOneBesideBy18DecibelsLessAndOthersNotAtAll() throws Exception {
        RadioField field = new RadioField(new Propagation(town(""), 0));
        double[] levels = new double[4];
        field.levelsDbm(1_000, 0, levels);

        double carrier = 10
                * Math.log10(ReceptionQuality.milliwatts(levels[0])
                        / (ReceptionQuality.milliwatts(levels[1])
                                + ReceptionQuality.milliwatts(levels[2] - 18)
                                + ReceptionQuality.milliwatts(ReceptionQuality.NOISE_DBM)));
        assertEquals(carrier, field.carrierDecibels(0, levels), 1e-9);

        field.set(1, new TowerState(false, 43));
        field.set(2, new TowerState(false, 43));
        field.levelsDbm(1_000, 0, levels);
        assertEquals(levels[0] - ReceptionQuality.NOISE_DBM, field.carrierDecibels(0, levels), 1e-6);
    }

    @Test
    void aBuildingWeakensAllTowersInsideAndNothingOutside() throws Exception {
        Propagation without = new Propagation(town(""), 0);
        Propagation with = new Propagation(town("building b 900 -10 1100 10 loss=20"), 0);

        for (int tower = 0; tower < 4; tower++) {
            assertEquals(without.lossDecibels(tower, 1_000, 0) + 20, with.lossDecibels(tower, 1_000, 0));
            assertEquals(without.lossDecibels(tower, 1_000, 11), with.lossDecibels(tower, 1_000, 11));
        }
    }

    @Test
    void aHillShadowsWhatLiesBehindItAndNotWhatLiesBeforeIt() throws Exception {
        Propagation without = new Propagation(town(""), 0);
        Propagation with = new Propagation(town("hill h 1000 0 radius=300 height=80"), 0);

        assertEquals(without.lossDecibels(0, 600, 0), with.lossDecibels(0, 600, 0));
        assertEquals(without.lossDecibels(0, 0, 900), with.lossDecibels(0, 0, 900));
        double behind = with.lossDecibels(0, 1_800, 0) - without.lossDecibels(0, 1_800, 0);
        assertTrue(behind > 15 && behind < 40, behind + " dB");
    }

    @Test
    void theRasterHasTheStrongestTowerOfEachSquareWithNorthAtTheTop() throws Exception {
        Town town = TownReader.read("t.town", """
                size 4000 2000
                shadow 0
                tower A 1000 1500 arfcn=20 bsic=1 lac=1
                tower B 3000 500 arfcn=30 bsic=2 lac=1
                """);
        Propagation propagation = new Propagation(town, 0);
        List<TowerState> on = List.of(new TowerState(true, 43), new TowerState(true, 43));

        LossRaster raster = LossRaster.of(propagation, 500);
        Coverage both = raster.coverage(on);
        assertEquals(8, both.columns());
        assertEquals(4, both.rows());
        assertEquals(0, both.best()[0]);
        assertEquals(1, both.best()[31]);
        assertEquals(43 - propagation.lossDecibels(0, 250, 1_750), both.levelDbm()[0], 1e-4);
        double lead = propagation.lossDecibels(1, 250, 1_750) - propagation.lossDecibels(0, 250, 1_750);
        assertEquals(lead, both.leadDecibels()[0], 1e-4);

        Coverage one = raster.coverage(List.of(new TowerState(false, 43), on.get(1)));
        assertTrue(IntStream.range(0, 32).allMatch(i -> one.best()[i] == 1));
        assertEquals(Float.POSITIVE_INFINITY, one.leadDecibels()[0]);
        Coverage none = raster.coverage(List.of(new TowerState(false, 43), new TowerState(false, 43)));
        assertEquals(Coverage.NONE, none.best()[0]);
    }
}
