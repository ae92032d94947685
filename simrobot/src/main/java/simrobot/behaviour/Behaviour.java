package simrobot.behaviour;

/**
 * A process of one robot, written by you: SimRobot asks it every 50 ms of simulated time how fast the robot is to drive.
 *
 * <p>The class needs a constructor without parameters; every robot that runs the process has an object of its own, and a
 * thread of its own that calls all methods. A decision that computes for more than 50 ms, or does not come within 1 s, ends
 * the process, as does everything that it throws; the robot then brakes.
 */
public interface Behaviour {
    /**
     * Makes one decision. It takes effect 50 ms of simulated time after the moment of the measurements.
     *
     * @param senses what the robot measures; the object stays as it is, so it may be kept
     * @return the speeds until the next decision
     */
    Steering decide(Senses senses);

    /** Asked after each decision: true ends the process, the robot brakes, and an order that started it is answered by 3. */
    default boolean isDone() {
        return false;
    }
}
