package simrobot.world;

import java.util.Objects;

/** A piece of furniture: its four sides are obstacles (MobileSim's {@code Sim.BoxObstacle}). */
public record Box(String name, Area area) {
    public Box {
        Objects.requireNonNull(name);
        Objects.requireNonNull(area);
    }
}
