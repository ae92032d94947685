package simrobot.process;

import java.util.List;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.world.Position;

/**
 * The drive to a place that another process requests: the route steers in its stead. It goes on where it was after a pause of
 * up to 1 s, as a late decision requests nothing. For the robot's owner thread.
 */
public final class Errand {
    private static final long LONGEST_PAUSE_NANOS = 1_000_000_000;

    private final String place;
    private final RobotProcess route;
    private long sinceRouteNanos = RobotProcess.TICK_NANOS;
    private long pauseNanos;
    private Decision last = new Decision.Go(Steering.STOP);

    /** @param route the process that drives to the place */
    public Errand(String place, RobotProcess route) {
        this.place = place;
        this.route = route;
    }

    /** True if it leads to this place, and was not abandoned. */
    public boolean isFor(String name) {
        return place.equals(name) && pauseNanos <= LONGEST_PAUSE_NANOS;
    }

    public boolean hasArrived() {
        return last instanceof Decision.Arrived;
    }

    /** The planned path; empty if it was abandoned. */
    public List<Position> path() {
        return isFor(place) ? route.path() : List.of();
    }

    /** Time has passed since the other process decided. */
    public void elapse(long nanos) {
        sinceRouteNanos += nanos;
        pauseNanos += nanos;
    }

    /** Replaces the speeds of the other process's decision by those of the route. */
    public Decision step(Decision.Go asking, Senses senses) {
        pauseNanos = 0;
        if (!hasArrived() && sinceRouteNanos >= route.periodNanos()) {
            sinceRouteNanos = 0;
            last = route.decide(senses);
        }
        if (last instanceof Decision.GivenUp givenUp) {
            return new Decision.Failed(0, "goTo(\"" + place + "\"): " + givenUp.text());
        }
        Steering steering = last instanceof Decision.Go go ? go.steering() : Steering.STOP;
        return last instanceof Decision.Collided ? last : new Decision.Go(steering, asking.asked());
    }
}
