package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.abis.RslMessage.BroadcastInformation;
import simgsm.abis.RslMessage.MeasurementResult;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.rr.SystemInformation;
import simgsm.station.context.StationContext;

/** The cell and its level as sent by a cells program; a centre alone sends neither. */
final class CellReception {
    private final StationContext context;
    private Optional<SystemInformation.Type3> information = Optional.empty();
    private int rxlev;

    CellReception(StationContext context) {
        this.context = context;
    }

    Optional<ServingCell> cell() {
        return information.map(
                cell -> new ServingCell(cell.cellIdentity(), cell.area().areaCode(), rxlev));
    }

    /** Information sent by the cell; empty before. */
    Optional<SystemInformation.Type3> information() {
        return information;
    }

    /** The link was lost. */
    void lost() {
        information = Optional.empty();
        rxlev = 0;
    }

    void arrived(BroadcastInformation message) throws ProtocolViolation {
        Optional<SystemInformation> decoded = SystemInformation.decode(message.block());
        if (decoded.isPresent() && decoded.get() instanceof SystemInformation.Type3 type3) {
            information = Optional.of(type3);
        } else {
            context.log().trace(Level.DEBUG, "system information type {0} is not used", message.type());
        }
    }

    void arrived(MeasurementResult message) throws ProtocolViolation {
        if (Layer3Codec.decode(message.report().toArray(), Direction.UPLINK) instanceof MeasurementReport report) {
            rxlev = report.results().fullLevel();
        }
    }
}
