package simrobot.camera;

import java.awt.image.BufferedImage;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Box;
import simrobot.world.World;
import vericommand.RobotStatus;

/**
 * Renders the images of the robots' cameras. Not thread-safe: an instance keeps its pixel buffer and the last world
 * drawn. Separate instances are independent.
 */
public final class Camera {
    public static final int WIDTH = 320;
    public static final int HEIGHT = 240;

    /** Distance ahead of the robot's centre of rotation. */
    private static final double MOUNT_X_METERS = 0.1;

    private static final double MOUNT_Z_METERS = 0.35;
    private static final double OPENING_RADIANS = Math.toRadians(62);

    /** Image colour of a camera without power. */
    private static final int DARK = 0x101214;

    private final PixelBuffer canvas = new PixelBuffer(WIDTH, HEIGHT);
    private World world;
    private WallPainter walls;
    private SignPainter signs;

    /** Returns the image of this robot's camera, {@link #WIDTH} x {@link #HEIGHT} pixels; dark if the robot is off. */
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
            signs = new SignPainter(world);
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
        signs.paint(canvas, eye);
        ObjectPainter bodies = new ObjectPainter(canvas, eye);
        for (Box box : world.items(Box.class)) {
            bodies.furniture(box);
        }
        for (RobotSnapshot other : scene.robots()) {
            if (!other.name().equals(robot.name())) {
                bodies.robot(other);
            }
        }
    }
}
