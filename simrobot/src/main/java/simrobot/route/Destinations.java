package simrobot.route;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import simrobot.process.BehaviourKind;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;

/** Makes processes that drive to a place of a world; they share one planner. Methods may be called on any thread. */
public final class Destinations {
    private static final String PREFIX = "goto ";
    private static final String DOCK = "Dock";

    private final RoutePlanner planner = new RoutePlanner();
    private volatile Executor executor = Runnable::run;

    public Destinations() {}

    /** Plans on this executor from now on; the default is the robot's own thread, so that a run repeats. */
    public void setExecutor(Executor plans) {
        executor = plans;
    }

    /** The processes for a world's named goals and docks: goals first, each name once. */
    public List<BehaviourKind> kinds(World world) {
        List<BehaviourKind> kinds = new ArrayList<>();
        Set<String> names = new HashSet<>();
        Stream.concat(
                        world.items(Goal.class).stream()
                                .filter(goal -> !goal.type().equals(DOCK)),
                        world.items(Goal.class).stream()
                                .filter(goal -> goal.type().equals(DOCK)))
                .filter(goal -> !goal.name().isBlank() && names.add(goal.name()))
                .forEach(goal -> kinds.add(to(goal)));
        return kinds;
    }

    /** The process for the goal, dock or robot home of this name; empty if the world has none. */
    public Optional<BehaviourKind> to(World world, String name) {
        Optional<BehaviourKind> goal = world.items(Goal.class).stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .map(this::to);
        return goal.or(() -> world.items(Home.class).stream()
                .filter(home -> home.name().equals(name))
                .findFirst()
                .map(this::to));
    }

    private BehaviourKind to(Goal goal) {
        OptionalDouble heading =
                goal.type().equals("Goal") ? OptionalDouble.empty() : OptionalDouble.of(goal.headingRadians());
        return kind(goal.name(), goal.position(), heading);
    }

    private BehaviourKind to(Home home) {
        return kind(home.name(), home.position(), OptionalDouble.of(home.headingRadians()));
    }

    /**
     * The process for a place.
     *
     * @param text the place as typed by the operator
     */
    public BehaviourKind to(String text, Position place) {
        return kind(text, place, OptionalDouble.empty());
    }

    private BehaviourKind kind(String name, Position place, OptionalDouble heading) {
        return new BehaviourKind(PREFIX + name, around -> new GoTo(around, planner, executor, place, heading));
    }
}
