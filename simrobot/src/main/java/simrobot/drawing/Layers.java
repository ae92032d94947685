package simrobot.drawing;

/** The parts of a picture that can be left out. */
public record Layers(boolean grid, boolean trail, boolean sonar) {
    public static final Layers ALL = new Layers(true, true, true);

    public Layers withGrid(boolean shown) {
        return new Layers(shown, trail, sonar);
    }

    public Layers withTrail(boolean shown) {
        return new Layers(grid, shown, sonar);
    }

    public Layers withSonar(boolean shown) {
        return new Layers(grid, trail, shown);
    }
}
