package simrobot.ros;

import java.io.IOException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The topics: a row has name, type, shortest period and content. */
enum RosTopic {
    ODOMETRY("/NAME/odom", "nav_msgs/Odometry", 50, RosMessages::odometry),
    SCAN("/NAME/scan", "sensor_msgs/LaserScan", 100, RosMessages::scan),
    SONAR("/NAME/sonar", "sensor_msgs/PointCloud", 100, RosMessages::sonar),
    BATTERY("/NAME/battery_state", "sensor_msgs/BatteryState", 1_000, RosMessages::battery),
    CAMERA("/NAME/camera/compressed", "sensor_msgs/CompressedImage", 100, RosMessages::camera),
    TRANSFORMS("/tf", "tf2_msgs/TFMessage", 50, RosMessages::transforms),
    CLOCK("/clock", "rosgraph_msgs/Clock", 50, RosMessages::clock),
    /** Published by clients, as the only topic. */
    VELOCITY("/NAME/cmd_vel", "geometry_msgs/Twist", 0, null);

    /** The other type of {@link #VELOCITY}, published by the stacks of ROS 2 Jazzy. */
    private static final String STAMPED = "geometry_msgs/TwistStamped";

    private static final String ROBOT = "/NAME";

    /** Creates the topic's message of one moment. */
    interface Content {
        Object message(RosMessages moment, String robot) throws IOException;
    }

    /** A topic, and its robot if the name includes one; else the robot is empty. */
    record Source(RosTopic topic, String robot) {}

    private final String pattern;
    private final String type;
    private final int periodMillis;
    private final Content content;

    RosTopic(String pattern, String type, int periodMillis, Content content) {
        this.pattern = pattern;
        this.type = type;
        this.periodMillis = periodMillis;
        this.content = content;
    }

    /** All topics of these robots by name; a single robot is also driven by {@code /cmd_vel}. */
    static Map<String, Source> all(List<String> robots) {
        Map<String, Source> named = new LinkedHashMap<>();
        for (RosTopic topic : values()) {
            for (String robot : robots) {
                named.putIfAbsent(
                        topic.pattern.replace(ROBOT, "/" + robot), new Source(topic, topic.isOfRobot() ? robot : ""));
            }
        }
        if (robots.size() == 1) {
            named.put(VELOCITY.pattern.replace(ROBOT, ""), new Source(VELOCITY, robots.get(0)));
        }
        return named;
    }

    private boolean isOfRobot() {
        return pattern.startsWith(ROBOT);
    }

    String type(RosGeneration generation) {
        return generation.typeName(type);
    }

    /** The generation of a type's name; empty if the topic has another type. */
    Optional<RosGeneration> generation(String name) {
        return Arrays.stream(RosGeneration.values())
                .filter(each -> type(each).equals(name)
                        || this == VELOCITY && each.typeName(STAMPED).equals(name))
                .findFirst();
    }

    int periodMillis() {
        return periodMillis;
    }

    /** True if clients publish it; the others are sent to them. */
    boolean isReceived() {
        return content == null;
    }

    /** True if its messages need the ranges of sonars and laser. */
    boolean needsRanges() {
        return this == SCAN || this == SONAR;
    }

    /** @throws IOException if the camera's picture cannot be encoded */
    Object message(RosMessages moment, String robot) throws IOException {
        return content.message(moment, robot);
    }
}
