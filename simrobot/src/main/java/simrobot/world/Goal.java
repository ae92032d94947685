package simrobot.world;

import java.util.Objects;

/**
 * A named place that is only drawn.
 *
 * @param type Goal, GoalWithHeading or Dock, as the map spells it
 * @param headingRadians anticlockwise from +X; a plain goal's means nothing
 */
public record Goal(String type, String name, Position position, double headingRadians) {
    public Goal {
        Objects.requireNonNull(type);
        Objects.requireNonNull(name);
        Objects.requireNonNull(position);
        Finite.check("heading", headingRadians);
    }
}
