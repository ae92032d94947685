package simrobot.behaviour;

/** The sonars of a robot at the moment of a decision; a range is computed when it is read. */
@FunctionalInterface
public interface SonarRanges {
    /** Returns the range of one sonar, 0.1 to 5 m. @param sonar 0 to 15, clockwise from the left */
    double meters(int sonar);
}
