package simrobot.simulation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Queue;
import simrobot.robot.Pioneer2Dx;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.DiscGrid;
import simrobot.world.Home;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * Finds places for robots without a given one: the world's homes in their order, then free places on square rings of growing
 * size around the first home, outside the boxes and apart from the homes. A place that was occupied once is not tried again, so the cost is linear in the number of
 * robots.
 */
final class StartPlaces {
    private static final double RASTER_METERS = 0.75;
    private static final double ROUNDING_METERS = 1e-9;
    private static final int MAX_RINGS = 400;
    private static final double RADIUS = Pioneer2Dx.RADIUS_METERS;

    /** True if a robot fits there. */
    interface Free {
        boolean at(double xMeters, double yMeters);
    }

    private final World world;
    private final Free free;
    private final Position center;
    private final Queue<Position> ring = new ArrayDeque<>();
    private int nextHome;
    private int nextRing;

    /** @param free takes each placed robot into account */
    StartPlaces(World world, Free free) {
        this(world, free, false);
    }

    /** @param fromMiddle true to search worlds without homes from their middle */
    StartPlaces(World world, Free free, boolean fromMiddle) {
        this.world = world;
        this.free = free;
        center =
                fromMiddle && world.items(Home.class).isEmpty() ? world.bounds().center() : center(world);
    }

    /** The next free place. @throws NoSuchElementException when there is none left */
    Home next() {
        while (nextHome < world.items(Home.class).size()) {
            Home home = world.items(Home.class).get(nextHome++);
            if (isFree(home.position())) {
                return home;
            }
        }
        while (!ring.isEmpty() || nextRing < MAX_RINGS) {
            if (ring.isEmpty()) {
                fillRing(nextRing++);
            }
            Position place = ring.remove();
            if (isFree(place) && !isInBox(place) && !isNearHome(place)) {
                return new Home("", place, 0);
            }
        }
        throw new NoSuchElementException("no free place in " + world.name());
    }

    /** The middle of a large box is far from its sides, but no path leads there. */
    private boolean isInBox(Position place) {
        return world.items(Box.class).stream().anyMatch(box -> box.area().contains(place.xMeters(), place.yMeters()));
    }

    /** True if a robot there would be nearer to one at home than to its neighbours, so that their first orders meet. */
    private boolean isNearHome(Position place) {
        return world.items(Home.class).stream()
                .map(Home::position)
                .anyMatch(home -> Math.hypot(home.xMeters() - place.xMeters(), home.yMeters() - place.yMeters())
                        < RASTER_METERS - ROUNDING_METERS);
    }

    private boolean isFree(Position place) {
        return free.at(place.xMeters(), place.yMeters());
    }

    /**
     * Places for several robots, in a world with other robots.
     *
     * @throws IllegalArgumentException if there are too few
     */
    static List<Home> find(World world, ObstacleGrid obstacles, int count, List<Position> occupied) {
        DiscGrid taken = new DiscGrid();
        for (int i = 0; i < occupied.size(); i++) {
            taken.put(count + i, occupied.get(i).xMeters(), occupied.get(i).yMeters());
        }
        StartPlaces places = new StartPlaces(
                world, (x, y) -> obstacles.isFree(x, y, RADIUS) && !taken.isCrowded(-1, x, y, 2 * RADIUS));
        List<Home> found = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            try {
                Home place = places.next();
                taken.put(i, place.position().xMeters(), place.position().yMeters());
                found.add(place);
            } catch (NoSuchElementException full) {
                throw new IllegalArgumentException("no free place for robot " + (i + 1) + " in " + world.name());
            }
        }
        return found;
    }

    /** The first home, else the origin if the world contains it (as in MobileSim), else the world's middle. */
    private static Position center(World world) {
        if (!world.items(Home.class).isEmpty()) {
            return world.items(Home.class).get(0).position();
        }
        Area bounds = world.bounds();
        return bounds.contains(0, 0) ? new Position(0, 0) : bounds.center();
    }

    private void fillRing(int number) {
        for (int row = -number; row <= number; row++) {
            boolean edge = Math.abs(row) == number;
            for (int column = -number; column <= number; column += edge || number == 0 ? 1 : 2 * number) {
                ring.add(new Position(
                        center.xMeters() + column * RASTER_METERS, center.yMeters() + row * RASTER_METERS));
            }
        }
    }
}
