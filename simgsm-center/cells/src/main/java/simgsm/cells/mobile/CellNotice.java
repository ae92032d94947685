package simgsm.cells.mobile;

import java.util.List;
import java.util.Optional;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.BroadcastInformation;
import simgsm.abis.RslMessage.MeasurementResult;
import simgsm.air.MeasurementResults;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.cells.radio.RadioScale;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.rr.SystemInformation;

/**
 * Informs a terminal, which has no receiver, of its cell and reception for its display. SYSTEM INFORMATION TYPE 3 is
 * sent at a change of the cell, a MEASUREMENT REPORT at a change of the level.
 */
final class CellNotice {
    private static final int FILLING = 0x2b;
    private static final int NUMBERS = 256;
    private static final int UNTOLD = -1;

    /** Sends a message to the terminal. */
    interface Sender {
        void send(RslMessage message);
    }

    private final Sender sender;
    private Optional<SystemInformation.Type3> toldCell = Optional.empty();
    private int toldLevel = UNTOLD;
    private int number;

    CellNotice(Sender sender) {
        this.sender = sender;
    }

    /**
     * Sends the state after a measurement.
     *
     * @param cell serving the mobile; empty for none, which the terminal sees as level 0
     */
    void tell(Optional<SystemInformation.Type3> cell, double dbm) {
        if (cell.isPresent() && !cell.equals(toldCell)) {
            toldCell = cell;
            sender.send(new BroadcastInformation(BroadcastInformation.TYPE_3, block(cell.get())));
        }
        int level = cell.isPresent() ? RadioScale.rxlev(dbm) : 0;
        if (level != toldLevel && toldCell.isPresent()) {
            toldLevel = level;
            sender.send(new MeasurementResult(number, report(level)));
            number = (number + 1) % NUMBERS;
        }
    }

    private static OctetString block(SystemInformation.Type3 information) {
        OctetWriter block = new OctetWriter().string(information.encode());
        for (int i = information.encode().length(); i < BroadcastInformation.BLOCK_LENGTH; i++) {
            block.octet(FILLING);
        }
        return block.toOctetString();
    }

    private static OctetString report(int level) {
        return ChannelChange.encoded(new MeasurementReport(MeasurementResults.of(level, 0, List.of())));
    }
}
