package simrobot.route;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import simrobot.world.Area;
import simrobot.world.Distances;
import simrobot.world.ForbiddenArea;
import simrobot.world.ForbiddenLine;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * Finds the shortest path for a disc of the robot's size, by A* on the clearance grid. Cells near obstacles cost more,
 * so a path keeps to the middle of a narrow place. The grid of the last world is cached. Methods may be called on any
 * thread.
 */
public final class RoutePlanner {
    /** Minimum distance to an obstacle: a robot's radius and a cell's diagonal. */
    static final double LEAST_CLEARANCE_METERS = 0.25 + 0.07;

    /** Distance to an obstacle below which a path costs up to three times its length. */
    private static final double WANTED_CLEARANCE_METERS = 0.6;

    /** Minimum distance to another robot's middle: two radii and 20 cm. */
    private static final double ROBOT_DISTANCE_METERS = 2 * 0.25 + 0.2;

    /** Distance within which a robot too near to an obstacle may leave it. */
    private static final double LEAVING_METERS = 0.6;

    private static final double DIAGONAL = Math.sqrt(2);

    private World known;
    private ClearanceGrid grid;

    public RoutePlanner() {}

    /**
     * A path, or the reason why there is none.
     *
     * @param refusal in English; empty if there is a path
     */
    public record Plan(List<Position> way, String refusal) {
        static Plan none(String refusal) {
            return new Plan(List.of(), refusal);
        }

        public boolean isFound() {
            return refusal.isEmpty();
        }
    }

    /**
     * Plans a path of straight legs that ends at the goal.
     *
     * @param robots positions of robots in the way
     */
    public Plan plan(World world, Position from, Position to, List<Position> robots) {
        ClearanceGrid cells = grid(world);
        int start = cells.cell(from.xMeters(), from.yMeters());
        int goal = cells.cell(to.xMeters(), to.yMeters());
        if (goal < 0) {
            return Plan.none("the goal lies outside the world");
        }
        if (cells.clearanceMeters(goal) < LEAST_CLEARANCE_METERS - cells.cellMeters()) {
            return Plan.none(
                    isForbidden(world, to)
                            ? "the goal lies in a forbidden area, or within 32 cm of one or of a forbidden line"
                            : "the goal lies in an obstacle or too near to one");
        }
        if (start < 0) {
            return Plan.none("the robot stands outside the world");
        }
        Search search = new Search(cells, start, goal, robots);
        boolean restricts = !world.items(ForbiddenLine.class).isEmpty()
                || !world.items(ForbiddenArea.class).isEmpty();
        return search.run()
                ? new Plan(search.way(to), "")
                : Plan.none(restricts ? "there is no way round obstacles and forbidden places" : "there is no way");
    }

    private static boolean isForbidden(World world, Position goal) {
        List<Area> areas = world.items(ForbiddenArea.class).stream()
                .map(ForbiddenArea::area)
                .toList();
        return Stream.concat(
                                world.items(ForbiddenLine.class).stream().map(ForbiddenLine::line),
                                areas.stream().flatMap(area -> area.sides().stream()))
                        .anyMatch(side -> distance(goal, side) < LEAST_CLEARANCE_METERS)
                || areas.stream().anyMatch(area -> area.contains(goal.xMeters(), goal.yMeters()));
    }

    private static double distance(Position place, Segment side) {
        return Distances.toSegment(
                place.xMeters(), place.yMeters(), side.x1Meters(), side.y1Meters(), side.x2Meters(), side.y2Meters());
    }

    private synchronized ClearanceGrid grid(World world) {
        if (known != world) {
            grid = new ClearanceGrid(world);
            known = world;
        }
        return grid;
    }

    /** One search. */
    private static final class Search {
        private static final int[] COLUMNS = {1, -1, 0, 0, 1, 1, -1, -1};
        private static final int[] ROWS = {0, 0, 1, -1, 1, -1, 1, -1};

        private final ClearanceGrid cells;
        private final int start;
        private final int goal;
        private final List<Position> robots;
        private final BitSet taken = new BitSet();
        private final float[] cost;
        private final int[] before;
        private final CellHeap open = new CellHeap();

        Search(ClearanceGrid cells, int start, int goal, List<Position> robots) {
            this.cells = cells;
            this.start = start;
            this.goal = goal;
            this.robots = robots;
            cost = new float[cells.cells()];
            Arrays.fill(cost, Float.POSITIVE_INFINITY);
            before = new int[cells.cells()];
            robots.forEach(this::take);
        }

        private void take(Position robot) {
            double reach = ROBOT_DISTANCE_METERS;
            // half a cell, so that rounding skips none
            double step = cells.cellMeters() / 2;
            for (double x = robot.xMeters() - reach; x <= robot.xMeters() + reach; x += step) {
                for (double y = robot.yMeters() - reach; y <= robot.yMeters() + reach; y += step) {
                    int cell = cells.cell(x, y);
                    if (cell >= 0 && Math.hypot(x - robot.xMeters(), y - robot.yMeters()) < reach) {
                        taken.set(cell);
                    }
                }
            }
        }

        boolean run() {
            cost[start] = 0;
            open.add(start, (float) toGo(start));
            while (!open.isEmpty()) {
                float estimate = open.leastCost();
                int cell = open.remove();
                if (cell == goal) {
                    return true;
                }
                if (estimate <= cost[cell] + toGo(cell) + 1e-3) {
                    expand(cell);
                }
            }
            return false;
        }

        private void expand(int cell) {
            int width = cells.width();
            int column = cell % width;
            for (int i = 0; i < COLUMNS.length; i++) {
                int nextColumn = column + COLUMNS[i];
                int next = cell + COLUMNS[i] + ROWS[i] * width;
                if (nextColumn < 0 || nextColumn >= width || next < 0 || next >= cost.length || !isFree(next)) {
                    continue;
                }
                double length = (i < 4 ? 1 : DIAGONAL) * cells.cellMeters();
                float sum = (float) (cost[cell] + length * weight(next));
                if (sum < cost[next]) {
                    cost[next] = sum;
                    before[next] = cell;
                    open.add(next, (float) (sum + toGo(next)));
                }
            }
        }

        private boolean isFree(int cell) {
            if (isTaken(cell)) {
                return false;
            }
            double clearance = cells.clearanceMeters(cell);
            return clearance >= LEAST_CLEARANCE_METERS
                    || cell == goal
                    || distance(cell, start) < LEAVING_METERS
                            && clearance >= cells.clearanceMeters(start) - cells.cellMeters()
                            && clearance > cells.cellMeters()
                    || distance(cell, goal) < LEAVING_METERS
                            && clearance >= LEAST_CLEARANCE_METERS - cells.cellMeters();
        }

        /** Permits a robot too near to another to pass or leave it, but not to approach it. */
        private boolean isTaken(int cell) {
            return taken.get(cell)
                    && robots.stream()
                            .anyMatch(robot -> distance(cell, robot)
                                    < Math.min(ROBOT_DISTANCE_METERS, distance(start, robot) - 0.01));
        }

        private double distance(int cell, Position place) {
            return Math.hypot(cells.xMeters(cell) - place.xMeters(), cells.yMeters(cell) - place.yMeters());
        }

        private double weight(int cell) {
            double clearance = cells.clearanceMeters(cell);
            return clearance >= WANTED_CLEARANCE_METERS
                    ? 1
                    : 1 + 2 * (WANTED_CLEARANCE_METERS - clearance) / WANTED_CLEARANCE_METERS;
        }

        private double distance(int cell, int other) {
            return Math.hypot(cells.xMeters(cell) - cells.xMeters(other), cells.yMeters(cell) - cells.yMeters(other));
        }

        /** A lower bound of the remaining cost, because a cell costs at least its length. */
        private double toGo(int cell) {
            double dx = Math.abs(cells.xMeters(cell) - cells.xMeters(goal));
            double dy = Math.abs(cells.yMeters(cell) - cells.yMeters(goal));
            return Math.max(dx, dy) + (DIAGONAL - 1) * Math.min(dx, dy);
        }

        /** The path, with straight legs if they keep as far from obstacles as the cells do. */
        List<Position> way(Position to) {
            Deque<Integer> steps = new ArrayDeque<>();
            for (int cell = goal; cell != start; cell = before[cell]) {
                steps.addFirst(cell);
            }
            List<Integer> all = new ArrayList<>(steps);
            List<Position> way = new ArrayList<>();
            int from = start;
            int i = 0;
            while (i < all.size()) {
                int reached = i;
                double least = Double.POSITIVE_INFINITY;
                for (int j = i; j < all.size(); j++) {
                    least = Math.min(least, Math.min(WANTED_CLEARANCE_METERS, cells.clearanceMeters(all.get(j))));
                    if (isStraight(from, all.get(j), least - cells.cellMeters())) {
                        reached = j;
                    } else if (j > reached + 40) {
                        break;
                    }
                }
                from = all.get(reached);
                i = reached + 1;
                way.add(i == all.size() ? to : cells.position(from));
            }
            if (way.isEmpty()) {
                way.add(to);
            }
            return List.copyOf(way);
        }

        private boolean isStraight(int from, int to, double clearance) {
            double length = distance(from, to);
            int steps = 1 + (int) (length / cells.cellMeters());
            for (int k = 1; k < steps; k++) {
                double share = (double) k / steps;
                double x = cells.xMeters(from) + share * (cells.xMeters(to) - cells.xMeters(from));
                double y = cells.yMeters(from) + share * (cells.yMeters(to) - cells.yMeters(from));
                int cell = cells.cell(x, y);
                if (isTaken(cell) || cells.clearanceMeters(cell) < clearance) {
                    return false;
                }
            }
            return true;
        }
    }
}
