package simrobot.drawing;

/**
 * The optional parts of a picture, and the language of its names.
 *
 * @param names of furniture, homes and goals
 */
public record Layers(boolean grid, boolean trail, boolean sonar, PlaceNames names) {
    public static final Layers ALL = new Layers(true, true, true);

    public Layers(boolean grid, boolean trail, boolean sonar) {
        this(grid, trail, sonar, PlaceNames.OF_FILE);
    }

    public Layers withGrid(boolean shown) {
        return new Layers(shown, trail, sonar, names);
    }

    public Layers withTrail(boolean shown) {
        return new Layers(grid, shown, sonar, names);
    }

    public Layers withSonar(boolean shown) {
        return new Layers(grid, trail, shown, names);
    }

    public Layers withNames(PlaceNames shown) {
        return new Layers(grid, trail, sonar, shown);
    }
}
