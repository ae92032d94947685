package simrobot.simulation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Queue;
import simrobot.robot.Pioneer2Dx;
import simrobot.world.Area;
import simrobot.world.DiscGrid;
import simrobot.world.Home;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * Finds places for robots that nobody has put anywhere: the world's homes in their order, then free places in ever wider
 * rings around the first home. What was not free once is not tried again, so a thousand robots take a thousand times as
 * long as one.
 */
final class StartPlaces {
    private static final double RASTER_METERS = 0.75;
    private static final int MAX_RINGS = 400;
    private static final double RADIUS = Pioneer2Dx.RADIUS_METERS;

    /** True when a robot fits there. */
    interface Free {
        boolean at(double xMeters, double yMeters);
    }

    private final World world;
    private final Free free;
    private final Position middle;
    private final Queue<Position> ring = new ArrayDeque<>();
    private int nextHome;
    private int nextRing;

    /** For robots that are put where they are told before the next place is asked for. */
    StartPlaces(World world, Free free) {
        this.world = world;
        this.free = free;
        middle = middle(world);
    }

    /** @throws NoSuchElementException when there is none left */
    Home next() {
        while (nextHome < world.homes().size()) {
            Home home = world.homes().get(nextHome++);
            if (isFree(home.position())) {
                return home;
            }
        }
        while (!ring.isEmpty() || nextRing < MAX_RINGS) {
            if (ring.isEmpty()) {
                layRing(nextRing++);
            }
            Position place = ring.remove();
            if (isFree(place)) {
                return new Home("", place, 0, Optional.empty());
            }
        }
        throw new NoSuchElementException("no free place in " + world.name());
    }

    private boolean isFree(Position place) {
        return free.at(place.xMeters(), place.yMeters());
    }

    /** Places for so many robots at once, on the floor without any. */
    static List<Home> spots(World world, int count) {
        return spots(world, new ObstacleGrid(world), count, List.of());
    }

    /** The same beside robots that stay where they are. */
    static List<Home> spots(World world, ObstacleGrid obstacles, int count, List<Position> staying) {
        DiscGrid taken = new DiscGrid();
        for (int i = 0; i < staying.size(); i++) {
            taken.put(count + i, staying.get(i).xMeters(), staying.get(i).yMeters());
        }
        StartPlaces parking = new StartPlaces(
                world, (x, y) -> obstacles.isFree(x, y, RADIUS) && !taken.isCrowded(-1, x, y, 2 * RADIUS));
        List<Home> spots = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            try {
                Home spot = parking.next();
                taken.put(i, spot.position().xMeters(), spot.position().yMeters());
                spots.add(spot);
            } catch (NoSuchElementException full) {
                throw new IllegalArgumentException("no free place for robot " + (i + 1) + " in " + world.name());
            }
        }
        return spots;
    }

    /** The first home, or near the origin (MobileSim's start). */
    private static Position middle(World world) {
        if (!world.homes().isEmpty()) {
            return world.homes().get(0).position();
        }
        Area bounds = world.bounds();
        return bounds.contains(0, 0) ? new Position(0, 0) : bounds.center();
    }

    private void layRing(int number) {
        for (int row = -number; row <= number; row++) {
            boolean edge = Math.abs(row) == number;
            for (int column = -number; column <= number; column += edge || number == 0 ? 1 : 2 * number) {
                ring.add(new Position(
                        middle.xMeters() + column * RASTER_METERS, middle.yMeters() + row * RASTER_METERS));
            }
        }
    }
}
