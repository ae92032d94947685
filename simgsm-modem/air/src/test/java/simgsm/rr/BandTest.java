package simgsm.rr;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BandTest {
    @ParameterizedTest
    @CsvSource({
        "0, GSM_900, 33, 5",
        "124, GSM_900, 13, 15",
        "511, GSM_900, 32, 5",
        "512, DCS_1800, 30, 0",
        "885, DCS_1800, 9, 10",
        "886, GSM_900, 33, 5",
        "1023, GSM_900, 5, 19"
    })
    void aChannelHasItsBandAndPowerControlLevels(int arfcn, Band band, int dbm, int level) {
        assertEquals(band, Band.of(arfcn));
        assertEquals(level, band.level(dbm));
        assertEquals(band.fullLevel(), band.level(band.fullDbm()));
    }

    @Test
    void reportsNumberTheListsOfTheCellsBandTogetherAndThenThoseOfOtherBands() {
        assertEquals(
                List.of(5, 70, 100, 600, 512),
                NeighbourList.inReports(Map.of(
                        NeighbourList.TYPE_5, List.of(100, 5),
                        NeighbourList.TYPE_5_BIS, List.of(70, 100),
                        NeighbourList.TYPE_5_TER, List.of(600, 512),
                        NeighbourList.TYPE_2, List.of(1))));
    }
}
