package simrobot.ui.floor;

/** What the world view draws beside floor, walls and robots. */
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
