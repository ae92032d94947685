package simrobot.camera;

import java.nio.file.Path;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.World;
import simrobot.world.WorldReader;

/**
 * How long a picture takes, and the picture itself. Arguments: a world file, a folder for pictures, and for every robot x,
 * y, heading in metres and degrees.
 */
final class CameraBench {
    private static final int PICTURES = 2000;

    private CameraBench() {}

    public static void main(String[] args) throws Exception {
        World world = WorldReader.read(Path.of(args[0]));
        Simulation simulation = new Simulation(world, 1);
        for (int i = 2; i + 2 < args.length; i += 3) {
            SimulatedRobot robot = simulation.addRobot("robot" + i / 3);
            robot.place(
                    Double.parseDouble(args[i]),
                    Double.parseDouble(args[i + 1]),
                    Math.toRadians(Double.parseDouble(args[i + 2])));
        }
        SimulationSnapshot scene = simulation.snapshot();
        Camera camera = new Camera();
        for (var robot : scene.robots()) {
            PictureFile.write(camera.picture(scene, robot), Path.of(args[1], robot.name() + ".png"));
        }
        for (int round = 0; round < 3; round++) {
            long start = System.nanoTime();
            for (int i = 0; i < PICTURES; i++) {
                camera.picture(scene, scene.robots().get(0));
            }
            System.out.printf("%.3f ms a picture%n", (System.nanoTime() - start) / 1e6 / PICTURES);
        }
        long start = System.nanoTime();
        byte[] jpeg = {};
        for (int i = 0; i < 200; i++) {
            jpeg = PictureFile.jpeg(camera.picture(scene, scene.robots().get(0)));
        }
        System.out.printf("%.3f ms with JPEG of %d bytes%n", (System.nanoTime() - start) / 1e6 / 200, jpeg.length);
    }
}
