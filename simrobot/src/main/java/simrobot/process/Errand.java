package simrobot.process;

import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Drives to a place at the request of another process and replaces its steering. For the robot's owner thread. */
public final class Errand {
    /** Nothing is asked for. */
    public static final Errand NONE = new Errand("", null);

    private final String place;
    private final RobotProcess route;
    private long sinceNanos = RobotProcess.TICK_NANOS;
    private Decision last = new Decision.Go(Steering.STOP);

    /** @param route the process that drives to the place */
    public Errand(String place, RobotProcess route) {
        this.place = place;
        this.route = route;
    }

    public String place() {
        return place;
    }

    public RobotProcess route() {
        return route;
    }

    public boolean hasArrived() {
        return last instanceof Decision.Arrived;
    }

    /** The decision of the other process, with the speeds of the route. @param passedNanos since its decision before */
    public Decision step(Decision.Go asking, Senses senses, long passedNanos) {
        sinceNanos += passedNanos;
        if (!hasArrived() && sinceNanos >= route.periodNanos()) {
            sinceNanos = 0;
            last = route.decide(senses);
        }
        if (last instanceof Decision.GivenUp givenUp) {
            return new Decision.Failed(0, "goTo(\"" + place + "\"): " + givenUp.text());
        }
        Steering steering = last instanceof Decision.Go go ? go.steering() : Steering.STOP;
        return last instanceof Decision.Collided ? last : new Decision.Go(steering, asking.asked());
    }
}
