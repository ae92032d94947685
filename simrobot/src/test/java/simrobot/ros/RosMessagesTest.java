package simrobot.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.web.JsonReader;
import simgsm.web.JsonText;
import simrobot.camera.CameraPictureCache;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/** The messages of a robot that starts at 1, 2 with heading 90 degrees, 3 m before a wall. */
class RosMessagesTest {
    private final Simulation simulation = new Simulation(World.of("wall", List.of(new Segment(-3, 5, 3, 5))), 1);
    private final SimulatedRobot robot = simulation.addRobot("ann", new Position(1, 2), Math.PI / 2);

    /** A value of the message, by a path such as {@code pose.pose.position.x}. */
    private Object value(RosTopic topic, RosGeneration generation, String path) throws IOException {
        RosMessages moment =
                new RosMessages(generation, simulation.snapshotWithRanges(Set.of("ann")), new CameraPictureCache());
        Object value = JsonReader.parse(
                new JsonText().any(topic.message(moment, "ann")).toString());
        for (String step : path.split("\\.")) {
            value = value instanceof List<?> list ? list.get(Integer.parseInt(step)) : ((Map<?, ?>) value).get(step);
        }
        return value;
    }

    private double number(RosTopic topic, String path) throws IOException {
        return ((BigDecimal) value(topic, RosGeneration.ROS_1, path)).doubleValue();
    }

    @Test
    void odometryIsInTheFrameInWhichTheRobotStarted() throws IOException {
        robot.drive().move(0.5);
        simulation.run(1_000);
        robot.drive().turn(Math.PI / 2);
        simulation.run(1_000);
        assertEquals(2.5, robot.yMeters(), 1e-9);
        assertEquals(0.5, number(RosTopic.ODOMETRY, "pose.pose.position.x"), 1e-9);
        assertEquals(0, number(RosTopic.ODOMETRY, "pose.pose.position.y"), 1e-9);
        assertEquals(Math.sqrt(0.5), number(RosTopic.ODOMETRY, "pose.pose.orientation.z"), 1e-9);
        assertEquals(Math.sqrt(0.5), number(RosTopic.ODOMETRY, "pose.pose.orientation.w"), 1e-9);
        assertEquals(0, number(RosTopic.ODOMETRY, "pose.covariance.35"));
        assertEquals(0.5, number(RosTopic.TRANSFORMS, "transforms.0.transform.translation.x"), 1e-9);
        assertEquals(0.018, number(RosTopic.TRANSFORMS, "transforms.1.transform.translation.x"), 1e-9);
        robot.drive().setSpeed(-0.1);
        robot.drive().setTurnSpeed(0.2);
        simulation.run(100);
        assertEquals(-0.1, number(RosTopic.ODOMETRY, "twist.twist.linear.x"), 1e-9);
        assertEquals(0.2, number(RosTopic.ODOMETRY, "twist.twist.angular.z"), 1e-9);
    }

    @ParameterizedTest
    @CsvSource({
        "ROS_1, header.seq, 150",
        "ROS_1, header.stamp.secs, 1",
        "ROS_1, header.stamp.nsecs, 500000000",
        "ROS_1, header.stamp.sec,",
        "ROS_2, header.seq,",
        "ROS_2, header.stamp.sec, 1",
        "ROS_2, header.stamp.nanosec, 500000000",
    })
    void stampsAreOfTheGenerationOfTheSubscription(RosGeneration generation, String path, BigDecimal expected)
            throws IOException {
        simulation.run(150);
        assertEquals(expected, value(RosTopic.ODOMETRY, generation, path));
    }

    @ParameterizedTest
    @EnumSource(RosGeneration.class)
    void theClockIsTheSimulations(RosGeneration generation) throws IOException {
        simulation.run(250);
        String seconds = generation == RosGeneration.ROS_1 ? "secs" : "sec";
        assertEquals(BigDecimal.valueOf(2), value(RosTopic.CLOCK, generation, "clock." + seconds));
    }

    @Test
    void rangesAreMetresFromTheRightAndNullWithoutAnEcho() throws IOException {
        assertEquals(3 - 0.018, number(RosTopic.SCAN, "ranges.90"), 1e-6);
        assertEquals(null, value(RosTopic.SCAN, RosGeneration.ROS_1, "ranges.0"));
        assertEquals(-Math.PI / 2, number(RosTopic.SCAN, "angle_min"), 1e-9);
        assertEquals(Math.PI / 2, number(RosTopic.SCAN, "angle_max"), 1e-9);
        assertEquals(3, number(RosTopic.SONAR, "points.3.x"), 0.05);
        assertEquals("laser", value(RosTopic.SCAN, RosGeneration.ROS_1, "header.frame_id"));
    }

    @Test
    void theBatteryIsFullAtTheStartAndWhatItDoesNotMeasureIsNull() throws IOException {
        assertEquals(12.7, number(RosTopic.BATTERY, "voltage"), 1e-9);
        assertEquals(1, number(RosTopic.BATTERY, "percentage"), 1e-9);
        assertEquals(null, value(RosTopic.BATTERY, RosGeneration.ROS_1, "current"));
    }

    @Test
    void theCamerasPictureIsAJpegInBase64() throws IOException {
        byte[] jpeg = Base64.getDecoder()
                .decode(value(RosTopic.CAMERA, RosGeneration.ROS_1, "data").toString());
        assertEquals(320, ImageIO.read(new ByteArrayInputStream(jpeg)).getWidth());
    }

    @Test
    void framesOfSeveralRobotsHaveTheirNames() throws IOException {
        assertEquals("base_link", value(RosTopic.ODOMETRY, RosGeneration.ROS_1, "child_frame_id"));
        simulation.addRobot("ben", new Position(0, 0), 0);
        assertEquals("ann/base_link", value(RosTopic.ODOMETRY, RosGeneration.ROS_1, "child_frame_id"));
        assertTrue(value(RosTopic.TRANSFORMS, RosGeneration.ROS_1, "transforms.2.header.frame_id")
                .equals("ben/odom"));
    }

    @Test
    void ofManyRobotsRangesAreThoseOfTheNamedOnes() {
        for (int i = 0; i < 20; i++) {
            simulation.addRobot("other" + i, new Position(-2 + i % 5, -i), 0);
        }
        List<Integer> counts = simulation.snapshotWithRanges(Set.of("ann")).robots().stream()
                .map(each -> each.sonarRangesMeters().length + each.laserRangesMeters().length)
                .toList();
        assertEquals(16 + 181, counts.get(0));
        assertEquals(0, counts.get(1));
    }
}
