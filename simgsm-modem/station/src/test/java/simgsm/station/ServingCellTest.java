package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.MeasurementResults;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** What a station shows of the cell of a town, as a cells program tells it. */
class ServingCellTest {
    private Scene scene;

    @BeforeEach
    void register() {
        scene = Scene.registered(StationOptions.STANDARD);
    }

    /** SYSTEM INFORMATION TYPE 3 of osmo-bsc for cell 0x1b3a in area 1. */
    private void inform(int cellIdentity) {
        String block = "49061b%04x00f1100001c9033c3d6500af00002b2b2b2b".formatted(cellIdentity);
        scene.frame(
                IpaFrame.RSL,
                new RslMessage.BroadcastInformation(RslMessage.BroadcastInformation.TYPE_3, OctetString.ofHex(block))
                        .encode());
    }

    private void measure(int rxlev) {
        byte[] report = Layer3Codec.encode(
                new MeasurementReport(MeasurementResults.of(rxlev, 0, List.of())), Direction.UPLINK, 0);
        scene.frame(
                IpaFrame.RSL,
                new RslMessage.MeasurementResult(
                                0, new OctetWriter().bytes(report).toOctetString())
                        .encode());
    }

    @Test
    void inItsOwnSmallCellAStationHasAllBars() {
        assertEquals(Optional.empty(), scene.station.snapshot().cell());
        assertEquals(5, scene.station.snapshot().signalBars(5));
    }

    @Test
    void theCellAndItsLevelAreThoseThatTheCellsProgramTells() {
        inform(0x1b3a);
        measure(39);

        assertEquals(
                Optional.of(new ServingCell(0x1b3a, 1, 39)),
                scene.station.snapshot().cell());
        assertEquals(-71, scene.station.snapshot().cell().orElseThrow().dbm());
        inform(0x1b3b);
        assertEquals(0x1b3b, scene.station.snapshot().cell().orElseThrow().identity());
    }

    @Test
    void afterTheLinkIsLostTheCellIsUnknown() {
        inform(0x1b3a);
        scene.linkDown();

        assertEquals(Optional.empty(), scene.station.snapshot().cell());
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "2, 0", "3, 1", "10, 1", "11, 2", "34, 4", "35, 5", "63, 5"})
    void aBarStandsForEightDecibels(int rxlev, int bars) {
        assertEquals(bars, new ServingCell(1, 1, rxlev).bars(5));
    }
}
