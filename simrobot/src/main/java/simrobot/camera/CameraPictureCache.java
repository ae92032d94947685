package simrobot.camera;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/** The camera pictures for all clients: each robot's picture is drawn once per scene. */
public final class CameraPictureCache {
    private static final int MOST_KEPT = 64;

    /** A robot's picture as JPEG, reused until a newer scene is requested. */
    public record Shot(SimulationSnapshot scene, byte[] jpeg) {}

    private final Camera camera = new Camera();
    private final Map<String, Shot> shots = new HashMap<>();

    public synchronized Shot shot(SimulationSnapshot scene, RobotSnapshot robot) throws IOException {
        Shot last = shots.get(robot.name());
        if (last != null && last.scene() == scene) {
            return last;
        }
        if (shots.size() >= MOST_KEPT) {
            shots.clear();
        }
        Shot shot = new Shot(scene, PictureFile.jpeg(camera.picture(scene, robot)));
        shots.put(robot.name(), shot);
        return shot;
    }
}
