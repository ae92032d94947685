package simrobot.ui;

import java.nio.file.Path;

/** What the person at the window may do; each act goes to the thread that owns what it touches. */
public interface Operator {
    void setPower(String robot, boolean on);

    void setMotors(String robot, boolean on);

    /** Puts a standing robot somewhere, if it fits there. */
    void place(String robot, double xMeters, double yMeters, double headingRadians);

    /** Brings the robot to rest with its own deceleration. */
    void brake(String robot);

    /** Wants this robot's sonars in the pictures, however many robots there are. */
    void watch(String robot);

    /** Simulated seconds per second; infinite is as fast as it can. */
    void setSpeed(double simulatedSecondsPerSecond);

    void setPaused(boolean paused);

    /** One step while paused. */
    void stepOnce();

    /** Loads another world; a problem is told through {@link WindowSnapshot#notice}. */
    void load(Path worldFile);
}
