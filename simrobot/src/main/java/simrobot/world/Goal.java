package simrobot.world;

import java.util.Objects;

/** A named place (a Goal, GoalWithHeading or Dock of the map); it is only drawn. */
public record Goal(String name, Position position) {
    public Goal {
        Objects.requireNonNull(name);
        Objects.requireNonNull(position);
    }
}
