package simrobot.ros;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import simrobot.camera.CameraPictureCache;
import simrobot.robot.Battery;
import simrobot.robot.Laser;
import simrobot.robot.LaserField;
import simrobot.robot.SonarRing;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import vericommand.Pose;

/**
 * The messages of one moment, as maps with fields in order: metres, radians anticlockwise, seconds of simulated time.
 * Odometry is relative to the robot's initial pose (REP 105). The frames of a single robot omit its name.
 */
final class RosMessages {
    private static final List<Integer> NO_COVARIANCE = Collections.nCopies(36, 0);
    private static final int DISCHARGING = 2;

    private final RosGeneration generation;
    private final SimulationSnapshot scene;
    private final CameraPictureCache cameras;

    RosMessages(RosGeneration generation, SimulationSnapshot scene, CameraPictureCache cameras) {
        this.generation = generation;
        this.scene = scene;
        this.cameras = cameras;
    }

    /**
     * Creates an object.
     *
     * @param names separated by blanks
     */
    static Map<String, Object> fields(String names, Object... values) {
        Map<String, Object> fields = new LinkedHashMap<>();
        for (String name : names.split(" ")) {
            fields.put(name, values[fields.size()]);
        }
        return fields;
    }

    private RobotSnapshot robot(String name) {
        return scene.robot(name).orElseThrow();
    }

    private String frame(String robot, String frame) {
        return scene.robots().size() == 1 ? frame : robot + "/" + frame;
    }

    private Map<String, Object> header(String robot, String frame) {
        return generation.header(scene.timeNanos(), frame(robot, frame));
    }

    private static Map<String, Object> vector(double x, double y, double z) {
        return fields("x y z", x, y, z);
    }

    private static Map<String, Object> turned(double radians) {
        return fields("x y z w", 0, 0, Math.sin(radians / 2), Math.cos(radians / 2));
    }

    Object odometry(String name) {
        RobotSnapshot robot = robot(name);
        Pose pose = robot.condition().odometry();
        Map<String, Object> place = fields(
                "position orientation",
                vector(pose.xMeters(), pose.yMeters(), 0),
                turned(Math.toRadians(pose.headingDegrees())));
        Map<String, Object> speeds = fields(
                "linear angular",
                vector(robot.speedMetersPerSecond(), 0, 0),
                vector(0, 0, robot.turnRadiansPerSecond()));
        return fields(
                "header child_frame_id pose twist",
                header(name, "odom"),
                frame(name, "base_link"),
                fields("pose covariance", place, NO_COVARIANCE),
                fields("twist covariance", speeds, NO_COVARIANCE));
    }

    /** The laser's ranges; infinite without an echo. */
    Object scan(String name) {
        LaserField field = LaserField.USUAL;
        List<Float> ranges = new ArrayList<>();
        for (double range : robot(name).laserRangesMeters()) {
            ranges.add(range < Laser.RANGE_METERS ? (float) range : Float.POSITIVE_INFINITY);
        }
        return fields(
                "header angle_min angle_max angle_increment time_increment scan_time range_min range_max ranges intensities",
                header(name, "laser"),
                field.radians(0),
                field.radians(field.count() - 1),
                Math.toRadians(field.stepDegrees()),
                0,
                RosTopic.SCAN.periodMillis() / 1e3,
                0,
                Laser.RANGE_METERS,
                ranges,
                List.of());
    }

    /** The sixteen points of the echoes, sonar 0 first; without an echo a point 5 m from its sonar. */
    Object sonar(String name) {
        double[] ranges = robot(name).sonarRangesMeters();
        List<Object> points = IntStream.range(0, ranges.length)
                .<Object>mapToObj(sonar -> vector(
                        SonarRing.mountX(sonar) + ranges[sonar] * Math.cos(SonarRing.directionRadians(sonar)),
                        SonarRing.mountY(sonar) + ranges[sonar] * Math.sin(SonarRing.directionRadians(sonar)),
                        0))
                .toList();
        return fields("header points channels", header(name, "base_link"), points, List.of());
    }

    /** The battery's state; unmeasured values are NaN. */
    Object battery(String name) {
        double volts = robot(name).condition().batteryVolts();
        return fields(
                "header voltage temperature current charge capacity design_capacity percentage power_supply_status power_supply_health power_supply_technology present cell_voltage cell_temperature location serial_number",
                header(name, "base_link"),
                volts,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Battery.chargeShare(volts),
                DISCHARGING,
                0,
                0,
                true,
                List.of(),
                List.of(),
                "",
                "");
    }

    Object camera(String name) throws IOException {
        byte[] jpeg = cameras.shot(scene, robot(name)).jpeg();
        return fields(
                "header format data",
                header(name, "camera"),
                "jpeg",
                Base64.getEncoder().encodeToString(jpeg));
    }

    /** The transforms of all robots, with the positions of their lasers. */
    Object transforms(String any) {
        List<Object> transforms = new ArrayList<>();
        for (RobotSnapshot robot : scene.robots()) {
            Pose pose = robot.condition().odometry();
            transforms.add(transform(robot.name(), "odom", "base_link", pose));
            transforms.add(transform(robot.name(), "base_link", "laser", new Pose(Laser.MOUNT_METERS, 0, 0)));
        }
        return fields("transforms", transforms);
    }

    private Object transform(String robot, String parent, String child, Pose pose) {
        return fields(
                "header child_frame_id transform",
                header(robot, parent),
                frame(robot, child),
                fields(
                        "translation rotation",
                        vector(pose.xMeters(), pose.yMeters(), 0),
                        turned(Math.toRadians(pose.headingDegrees()))));
    }

    Object clock(String any) {
        return fields("clock", generation.time(scene.timeNanos()));
    }
}
