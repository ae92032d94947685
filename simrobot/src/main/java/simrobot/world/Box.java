package simrobot.world;

import java.util.List;
import java.util.Objects;

/** A piece of furniture: its four sides are obstacles (MobileSim's {@code Sim.BoxObstacle}). */
public record Box(String name, Area area) implements WorldItem {
    public Box {
        Objects.requireNonNull(name);
        Objects.requireNonNull(area);
    }

    @Override
    public Box movedBy(double dxMeters, double dyMeters) {
        return new Box(name, area.movedBy(dxMeters, dyMeters));
    }

    @Override
    public List<Position> handles() {
        return area.corners();
    }

    @Override
    public Box pulled(int handle, Position to) {
        return new Box(name, area.pulled(handle, to));
    }
}
