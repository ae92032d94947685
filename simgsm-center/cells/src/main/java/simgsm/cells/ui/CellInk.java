package simgsm.cells.ui;

import java.util.List;
import simgsm.draw.Ink;

/** The colours of cells, in the order of the town's towers. */
final class CellInk {
    private static final List<Ink> INKS =
            List.of(Ink.CELL_1, Ink.CELL_2, Ink.CELL_3, Ink.CELL_4, Ink.CELL_5, Ink.CELL_6, Ink.CELL_7);

    private CellInk() {}

    /** @param tower its index in the town; any other number for none */
    static Ink of(int tower) {
        return tower < 0 ? Ink.QUIET : INKS.get(tower % INKS.size());
    }
}
