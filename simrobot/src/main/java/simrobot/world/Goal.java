package simrobot.world;

import java.util.Objects;

/**
 * A named place to which robots can be sent.
 *
 * @param type Goal, GoalWithHeading or Dock, as the map spells it
 * @param headingRadians anticlockwise from +X; without meaning for the type Goal
 */
public record Goal(String type, String name, Position position, double headingRadians) {
    public Goal {
        Objects.requireNonNull(type);
        Objects.requireNonNull(name);
        Objects.requireNonNull(position);
        FiniteCheck.check("heading", headingRadians);
    }
}
