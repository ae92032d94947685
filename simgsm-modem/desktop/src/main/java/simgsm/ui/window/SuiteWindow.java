package simgsm.ui.window;

import java.awt.Dimension;

/** The least sizes of the suite's windows at 100 %, frames included; they grow in proportion to the zoom. */
public enum SuiteWindow {
    PHONE(336, 660),
    ROBOT(764, 432),
    CENTER(860, 288),
    CELLS(760, 420);

    private final int widthUnits;
    private final int heightUnits;

    SuiteWindow(int widthUnits, int heightUnits) {
        this.widthUnits = widthUnits;
        this.heightUnits = heightUnits;
    }

    public int widthUnits() {
        return widthUnits;
    }

    public int heightUnits() {
        return heightUnits;
    }

    public Dimension least() {
        return new Dimension(widthUnits, heightUnits);
    }
}
