package simrobot.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simrobot.replay.Recording;
import simrobot.replay.ReplayCursor;
import simrobot.robot.RobotState;
import simrobot.simulation.WanderRun;
import simrobot.world.Segment;
import simrobot.world.World;

class WanderRecordingTest {
    private static final int STEPS = 1_000;
    private static final World ROOM = World.ofSegments(
            "room",
            List.of(
                    new Segment(0, 0, 8, 0),
                    new Segment(8, 0, 8, 6),
                    new Segment(8, 6, 0, 6),
                    new Segment(0, 6, 0, 0)));

    @TempDir
    Path folder;

    @Test
    void aWandererRunComesBackToTheLastBit() throws IOException {
        Path file = folder.resolve("run.rec");
        WanderRun recorded = new WanderRun(ROOM, 3);
        try (WanderRecording recording =
                WanderRecording.open(file, ROOM, recorded, List.of("anna", "berta", "clara"))) {
            for (int step = 0; step < STEPS; step++) {
                recorded.step();
                recording.step();
            }
        }
        WanderRun again = new WanderRun(ROOM, 3);
        try (Recording recording = Recording.open(file)) {
            assertEquals(STEPS * WanderRun.STEP_NANOS, recording.lastNanos());
            ReplayCursor cursor = new ReplayCursor(recording);
            for (int step = 1; step <= STEPS; step++) {
                again.step();
                cursor.seek(step * WanderRun.STEP_NANOS);
                for (int i = 0; i < 3; i++) {
                    assertSamePose(again, i, cursor.robots().get(i).state());
                }
            }
        }
    }

    private static void assertSamePose(WanderRun run, int robot, RobotState state) {
        assertEquals(run.xMeters(robot), state.xMeters());
        assertEquals(run.yMeters(robot), state.yMeters());
        assertEquals(run.headingRadians(robot), state.headingRadians());
        assertEquals(run.speedMetersPerSecond(robot), state.speedMetersPerSecond());
        assertEquals(run.turnRadiansPerSecond(robot), state.turnRadiansPerSecond());
    }

    @Test
    void robotsThatWanderDoMove() {
        WanderRun run = new WanderRun(ROOM, 1);
        double x = run.xMeters(0);
        double y = run.yMeters(0);
        run.step();
        assertEquals(0.4, run.speedMetersPerSecond(0));
        assertTrue(Math.hypot(run.xMeters(0) - x, run.yMeters(0) - y) > 0.039);
    }
}
