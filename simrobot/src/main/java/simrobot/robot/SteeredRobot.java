package simrobot.robot;

import simrobot.behaviour.Steering;

/** A robot, simulated or real, as its {@link Autonomy} steers it. */
public interface SteeredRobot extends Pioneer {
    /** Whether it executes an instruction, or an order waits until it stands. */
    boolean isUnderOrder();

    /** Sets the wheels' target speeds. */
    void steer(Steering steering);

    /** Brakes with the robot's deceleration. */
    void stopSteering();

    /** A process begins to steer a robot that is Stopped: it is Moving until the process ends, also while it stands. */
    void countAsMoving();

    /** New senses, for a process that begins. */
    ProcessSenses newSenses();
}
