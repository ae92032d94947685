package simgsm.phone.ui;

/** The panel that is open below the keys or at their right. */
enum HandsetFold {
    NONE(0),
    /** The tone scope. */
    SCOPE(376),
    /** The log of events; its height fits below the phone on a screen of 768 lines. */
    EVENTS(140);

    private final double heightUnits;

    HandsetFold(double heightUnits) {
        this.heightUnits = heightUnits;
    }

    double heightUnits() {
        return heightUnits;
    }
}
