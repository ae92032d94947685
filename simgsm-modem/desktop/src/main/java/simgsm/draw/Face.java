package simgsm.draw;

/** A type face by its task; its size is in units of the design. */
public enum Face {
    SMALL(11, false, false),
    BASE(13, false, false),
    STRONG(13, false, true),
    MONO_SMALL(11, true, false),
    MONO_STRONG(13, true, true);

    private final double points;
    private final boolean monospaced;
    private final boolean bold;

    Face(double points, boolean monospaced, boolean bold) {
        this.points = points;
        this.monospaced = monospaced;
        this.bold = bold;
    }

    public double points() {
        return points;
    }

    public boolean isMonospaced() {
        return monospaced;
    }

    public boolean isBold() {
        return bold;
    }
}
