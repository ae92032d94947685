package simrobot.process;

import simrobot.behaviour.Requests;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** The drive to a place for which a process of a student has asked: it steers in the process's stead. */
public final class Errand {
    private final String place;
    private final RobotProcess route;
    private long sinceNanos;
    private Decision last = new Decision.Go(Steering.STOP);

    /** @param route the process that drives to the place */
    public Errand(String place, RobotProcess route) {
        this.place = place;
        this.route = route;
        sinceNanos = route.periodNanos();
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

    /** The decision of the process with the steering of the route. @param passedNanos since the decision before */
    public Decision step(Requests asked, Senses senses, long passedNanos) {
        sinceNanos += passedNanos;
        if (!hasArrived() && sinceNanos >= route.periodNanos()) {
            sinceNanos = 0;
            last = route.decide(senses);
        }
        if (last instanceof Decision.GivenUp givenUp) {
            return new Decision.Failed(0, "goTo(\"" + place + "\"): " + givenUp.text());
        }
        boolean drives = last instanceof Decision.Go || hasArrived();
        Steering steering = last instanceof Decision.Go go ? go.steering() : Steering.STOP;
        return drives ? new Decision.Go(asked.with(steering)) : last;
    }
}
