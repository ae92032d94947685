package simrobot.ros;

import java.util.LinkedHashMap;
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
        Map<String, Object> time = new LinkedHashMap<>();
        time.put(seconds, TimeUnit.NANOSECONDS.toSeconds(nanos));
        time.put(nanoseconds, nanos % TimeUnit.SECONDS.toNanos(1));
        return time;
    }

    /** std_msgs/Header; its number in ROS 1 counts the steps of the simulation. */
    Map<String, Object> header(long nanos, String frame) {
        Map<String, Object> header = new LinkedHashMap<>();
        if (this == ROS_1) {
            header.put("seq", nanos / Simulation.STEP_NANOS);
        }
        header.put("stamp", time(nanos));
        header.put("frame_id", frame);
        return header;
    }
}
