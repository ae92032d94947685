package simrobot.ros;

import java.util.Map;
import java.util.concurrent.TimeUnit;
import simrobot.simulation.Simulation;

/** The two generations of ROS, which differ in the names of types and in time stamps. */
enum RosGeneration {
    ROS_1("/", "secs", "nsecs"),
    ROS_2("/msg/", "sec", "nanosec");

    private final String separator;
    private final String seconds;
    private final String nanoseconds;

    RosGeneration(String separator, String seconds, String nanoseconds) {
        this.separator = separator;
        this.seconds = seconds;
        this.nanoseconds = nanoseconds;
    }

    /** A message type's name: {@code nav_msgs/Odometry} or {@code nav_msgs/msg/Odometry}. @param type as in ROS 1 */
    String typeName(String type) {
        return type.replace("/", separator);
    }

    /** A time as message. @param nanos simulated time */
    Map<String, Object> time(long nanos) {
        return RosMessages.fields(
                seconds + " " + nanoseconds,
                TimeUnit.NANOSECONDS.toSeconds(nanos),
                nanos % TimeUnit.SECONDS.toNanos(1));
    }

    /** std_msgs/Header; its number in ROS 1 counts the steps of the simulation. */
    Map<String, Object> header(long nanos, String frame) {
        return this == ROS_1
                ? RosMessages.fields("seq stamp frame_id", nanos / Simulation.STEP_NANOS, time(nanos), frame)
                : RosMessages.fields("stamp frame_id", time(nanos), frame);
    }
}
