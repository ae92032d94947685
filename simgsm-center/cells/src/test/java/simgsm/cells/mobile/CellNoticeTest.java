package simgsm.cells.mobile;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.BroadcastInformation;
import simgsm.abis.RslMessage.MeasurementResult;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.LocationArea;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.rr.SystemInformation;

/** The cell and level that a terminal receives, as it reads them. */
class CellNoticeTest {
    private final List<String> told = new ArrayList<>();
    private final CellNotice notice = new CellNotice(message -> told.add(asRead(message)));

    private static Optional<SystemInformation.Type3> cell(int identity) {
        return Optional.of(new SystemInformation.Type3(
                identity,
                LocationArea.TEST,
                new SystemInformation.ControlChannel(true, 1, true, 5, 0),
                32,
                new SystemInformation.SelectionParameters(4, 5, 5),
                new SystemInformation.RandomAccess(7, 32, false),
                Optional.empty()));
    }

    private static String asRead(RslMessage message) {
        try {
            RslMessage read = RslMessage.decode(message.encode());
            if (read instanceof BroadcastInformation information) {
                return "cell "
                        + SystemInformation.decode(information.block())
                                .map(SystemInformation.Type3.class::cast)
                                .orElseThrow()
                                .cellIdentity();
            }
            MeasurementResult result = (MeasurementResult) read;
            MeasurementReport report =
                    (MeasurementReport) Layer3Codec.decode(result.report().toArray(), Direction.UPLINK);
            return "level " + report.results().fullLevel() + " number " + result.number();
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void theCellIsSentWhenItChangesAndTheLevelWhenItDoes() {
        notice.tell(cell(7001), -71);
        notice.tell(cell(7001), -71.2);
        notice.tell(cell(7001), -75);
        notice.tell(cell(7002), -75);

        assertEquals(List.of("cell 7001", "level 39 number 0", "level 35 number 1", "cell 7002"), told);
    }

    @Test
    void aMobileWithoutCellHasLevelZero() {
        notice.tell(Optional.empty(), 0);
        assertEquals(List.of(), told);
        notice.tell(cell(7001), -100);
        notice.tell(Optional.empty(), 0);
        notice.tell(cell(7001), -100);

        assertEquals(List.of("cell 7001", "level 10 number 0", "level 0 number 1", "level 10 number 2"), told);
    }
}
