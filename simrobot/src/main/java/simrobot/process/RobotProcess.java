package simrobot.process;

import java.util.List;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.world.Position;

/** A running process of one robot; all methods are called by the robot's owner thread. */
public interface RobotProcess {
    /** Period of the built-in rules, that of a Pioneer's information packets. */
    long TICK_NANOS = 100_000_000;

    /** Simulated time between two decisions. */
    default long periodNanos() {
        return TICK_NANOS;
    }

    /**
     * Makes one decision.
     *
     * @param senses live, so valid during the call only
     */
    Decision decide(Senses senses);

    /** Frees the resources of the process; called once, however it ended. */
    default void close() {}

    /** The planned path, for drawing; empty if there is none. */
    default List<Position> path() {
        return List.of();
    }

    /** A rule that decides at once, on the caller's thread. */
    static RobotProcess inPlace(Behaviour rule) {
        return senses -> new Decision.Go(rule.decide(senses));
    }
}
