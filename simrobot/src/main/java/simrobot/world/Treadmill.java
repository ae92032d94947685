package simrobot.world;

import java.util.List;
import java.util.Objects;

/**
 * A belt in the floor that moves every robot whose centre of rotation is on it. An addition to the map format: wheels slip on
 * it, so that the paper's "infinite loop" can occur.
 *
 * @param area not rotated
 * @param speedMetersPerSecond along the direction; negative runs against it
 * @param directionRadians anticlockwise from +X
 */
public record Treadmill(Area area, double speedMetersPerSecond, double directionRadians) implements WorldItem {
    public Treadmill {
        Objects.requireNonNull(area);
        FiniteCheck.check("belt speed", speedMetersPerSecond);
        FiniteCheck.check("direction", directionRadians);
    }

    @Override
    public Treadmill movedBy(double dxMeters, double dyMeters) {
        return new Treadmill(area.movedBy(dxMeters, dyMeters), speedMetersPerSecond, directionRadians);
    }

    @Override
    public List<Position> handles() {
        return area.corners();
    }

    @Override
    public Treadmill pulled(int handle, Position to) {
        return new Treadmill(area.pulled(handle, to), speedMetersPerSecond, directionRadians);
    }

    public double velocityX() {
        return speedMetersPerSecond * Math.cos(directionRadians);
    }

    public double velocityY() {
        return speedMetersPerSecond * Math.sin(directionRadians);
    }
}
