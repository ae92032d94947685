package simrobot.behaviour;

/** An autonomous process in one robot: a rule from what the sonars hear to how the robot goes on. */
public interface Behaviour {
    /** Simulated time between two decisions: the sonars' own beat in a Pioneer's information packets. */
    long TICK_NANOS = 100_000_000;

    /**
     * One decision, every {@link #TICK_NANOS}.
     *
     * @param sonars valid during the call only
     * @param blocked whether the robot has run against something and is held by it
     * @return what to do until the next decision
     */
    Steering decide(SonarRanges sonars, boolean blocked);
}
