package simrobot.world;

import java.util.Objects;
import java.util.Optional;

/**
 * Where a robot starts.
 *
 * @param name the name in the file, empty when it has none
 * @param headingRadians anticlockwise from +X
 * @param area the home's rectangle when the file gives one
 */
public record Home(String name, Position position, double headingRadians, Optional<Area> area) {
    public Home {
        Objects.requireNonNull(name);
        Objects.requireNonNull(position);
        Objects.requireNonNull(area);
        Finite.check("heading", headingRadians);
    }
}
