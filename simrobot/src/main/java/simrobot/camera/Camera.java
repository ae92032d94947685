package simrobot.camera;

import java.awt.image.BufferedImage;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Box;
import simrobot.world.World;
import vericommand.RobotStatus;

/**
 * Draws what robots see. It keeps its canvas and the world that it drew last, so one thread at a time may use it; several
 * cameras do not disturb each other.
 */
public final class Camera {
    public static final int WIDTH = 320;
    public static final int HEIGHT = 240;

    /** Ahead of the centre of rotation, on the mast. */
    private static final double MOUNT_X_METERS = 0.1;

    private static final double MOUNT_Z_METERS = 0.35;
    private static final double OPENING_RADIANS = Math.toRadians(62);

    /** A camera that gets no power. */
    private static final int DARK = 0x101214;

    private final PixelBuffer canvas = new PixelBuffer(WIDTH, HEIGHT);
    private World world;
    private WallPainter walls;

    /** What this robot's camera sees; dark when the robot is switched off. */
    public BufferedImage picture(SimulationSnapshot scene, RobotSnapshot robot) {
        if (robot.status() == RobotStatus.DISCONNECTED) {
            canvas.fill(DARK);
        } else {
            paint(scene, robot);
        }
        return canvas.picture();
    }

    private void paint(SimulationSnapshot scene, RobotSnapshot robot) {
        if (scene.world() != world) {
            world = scene.world();
            walls = new WallPainter(world);
        }
        double heading = robot.headingRadians();
        PinholeView eye = PinholeView.at(
                robot.xMeters() + MOUNT_X_METERS * Math.cos(heading),
                robot.yMeters() + MOUNT_X_METERS * Math.sin(heading),
                MOUNT_Z_METERS,
                heading,
                canvas.width,
                canvas.height,
                OPENING_RADIANS);
        new BackgroundPainter(canvas, eye).paint(world);
        walls.paint(canvas, eye);
        ObjectPainter bodies = new ObjectPainter(canvas, eye);
        for (Box box : world.boxes()) {
            bodies.furniture(box);
        }
        for (RobotSnapshot other : scene.robots()) {
            if (!other.name().equals(robot.name())) {
                bodies.robot(other);
            }
        }
    }
}
