package simrobot.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simrobot.robot.Pioneer2Dx;
import simrobot.world.Area;
import simrobot.world.Home;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.World;

/** Finds a place for a robot that nobody has put anywhere. */
final class Parking {
    private static final double RASTER_METERS = 0.75;
    private static final int MAX_RINGS = 400;

    /** True when a robot fits there. */
    interface Free {
        boolean at(double xMeters, double yMeters);
    }

    private Parking() {}

    /** The first free home; else a free place near the first home, or near the origin (MobileSim's start). */
    static Optional<Home> spot(World world, Free free) {
        for (Home home : world.homes()) {
            if (free.at(home.position().xMeters(), home.position().yMeters())) {
                return Optional.of(home);
            }
        }
        return ringsAround(middle(world), free);
    }

    /** Places for so many robots at once. */
    static List<Home> spots(World world, int count) {
        ObstacleGrid obstacles = new ObstacleGrid(world);
        double radius = Pioneer2Dx.RADIUS_METERS;
        List<Home> taken = new ArrayList<>();
        Free free = (x, y) -> obstacles.clearance(x, y, radius) >= radius
                && taken.stream()
                        .allMatch(home -> Math.hypot(
                                        home.position().xMeters() - x,
                                        home.position().yMeters() - y)
                                >= 2 * radius);
        for (int i = 0; i < count; i++) {
            int next = i + 1;
            taken.add(spot(world, free)
                    .orElseThrow(() ->
                            new IllegalArgumentException("no free place for robot " + next + " in " + world.name())));
        }
        return taken;
    }

    private static Position middle(World world) {
        if (!world.homes().isEmpty()) {
            return world.homes().get(0).position();
        }
        Area bounds = world.bounds();
        return bounds.contains(0, 0) ? new Position(0, 0) : bounds.center();
    }

    private static Optional<Home> ringsAround(Position middle, Free free) {
        for (int ring = 0; ring < MAX_RINGS; ring++) {
            for (int row = -ring; row <= ring; row++) {
                boolean edge = Math.abs(row) == ring;
                for (int column = -ring; column <= ring; column += edge || ring == 0 ? 1 : 2 * ring) {
                    double x = middle.xMeters() + column * RASTER_METERS;
                    double y = middle.yMeters() + row * RASTER_METERS;
                    if (free.at(x, y)) {
                        return Optional.of(new Home("", new Position(x, y), 0, Optional.empty()));
                    }
                }
            }
        }
        return Optional.empty();
    }
}
