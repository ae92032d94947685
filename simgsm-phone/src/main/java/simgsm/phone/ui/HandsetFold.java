package simgsm.phone.ui;

/** What is open below or beside the keys. */
enum HandsetFold {
    NONE(0),
    /** The tone scope. */
    SCOPE(376),
    /** What just happened; low, so that it fits under the phone on a screen of 768 lines, too. */
    EVENTS(140);

    private final double heightUnits;

    HandsetFold(double heightUnits) {
        this.heightUnits = heightUnits;
    }

    double heightUnits() {
        return heightUnits;
    }
}
