package simrobot.behaviour;

/** An autonomous process of one robot: maps the sonar ranges to the robot's speeds. */
public interface Behaviour {
    /** Simulated time between two decisions, equal to the period of a Pioneer's information packets. */
    long TICK_NANOS = 100_000_000;

    /**
     * Makes one decision; called every {@link #TICK_NANOS}.
     *
     * @param sonars valid during the call only
     * @param blocked whether a collision keeps the robot from moving
     * @return the speeds until the next decision
     */
    Steering decide(SonarRanges sonars, boolean blocked);
}
