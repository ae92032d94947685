package simrobot.world;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Where a robot starts.
 *
 * @param name the name in the file, empty when it has none
 * @param headingRadians anticlockwise from +X
 * @param area the home's rectangle when the file gives one
 */
public record Home(String name, Position position, double headingRadians, Optional<Area> area) implements WorldItem {
    /** Distance of the handle that turns the home from its middle. */
    private static final double HEADING_HANDLE_METERS = 0.6;

    public Home {
        Objects.requireNonNull(name);
        Objects.requireNonNull(position);
        Objects.requireNonNull(area);
        FiniteCheck.check("heading", headingRadians);
    }

    @Override
    public Home movedBy(double dxMeters, double dyMeters) {
        return new Home(
                name,
                position.movedBy(dxMeters, dyMeters),
                headingRadians,
                area.map(here -> here.movedBy(dxMeters, dyMeters)));
    }

    @Override
    public List<Position> handles() {
        return List.of(new Position(
                position.xMeters() + HEADING_HANDLE_METERS * Math.cos(headingRadians),
                position.yMeters() + HEADING_HANDLE_METERS * Math.sin(headingRadians)));
    }

    /** Turned towards that place, in whole degrees; a turned home has no area. */
    @Override
    public Home pulled(int handle, Position to) {
        double towards = Math.atan2(to.yMeters() - position.yMeters(), to.xMeters() - position.xMeters());
        return new Home(name, position, Math.toRadians(Math.rint(Math.toDegrees(towards))), Optional.empty());
    }
}
