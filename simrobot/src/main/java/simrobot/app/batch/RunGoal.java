package simrobot.app.batch;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;

/** The place that the robots of a run must reach. */
record RunGoal(String name, Position position) {
    private static final double REACHED_METERS = 0.3;

    /** @throws IllegalArgumentException if the world has no home, goal or dock of this name; the message lists the names */
    static RunGoal named(World world, String name) {
        List<RunGoal> places = Stream.concat(
                        // a goal comes before a home of the same name, as in Destinations
                        world.items(Goal.class).stream().map(goal -> new RunGoal(goal.name(), goal.position())),
                        world.items(Home.class).stream().map(home -> new RunGoal(home.name(), home.position())))
                .toList();
        return places.stream()
                .filter(place -> place.name.equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("expected a home or goal of the world ("
                        + places.stream().map(RunGoal::name).distinct().collect(Collectors.joining(", "))
                        + "), found " + name));
    }

    double metersFrom(SimulatedRobot robot) {
        return Math.hypot(robot.xMeters() - position.xMeters(), robot.yMeters() - position.yMeters());
    }

    boolean isReachedBy(SimulatedRobot robot) {
        return metersFrom(robot) <= REACHED_METERS;
    }
}
