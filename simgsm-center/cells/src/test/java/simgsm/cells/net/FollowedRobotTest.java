package simgsm.cells.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FollowedRobotTest {
    private static final String URL = "http://127.0.0.1:8080/robots/robot";

    @Test
    void theScaleIsOneUnlessItIsGiven() {
        assertEquals(1, FollowedRobot.parse("5550200=" + URL).scale());
        FollowedRobot scaled = FollowedRobot.parse("5550200=" + URL + ",12.5");
        assertEquals(12.5, scaled.scale());
        assertEquals(URL, scaled.url().toString());
        assertEquals("5550200", scaled.number());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "5550200", "=" + URL, "5550200=ftp://x/robots/r", "5550200=http://x/r", "1=" + URL + ",-1"})
    void anythingElseIsRefusedWithTheForm(String text) {
        IllegalArgumentException refused =
                assertThrows(IllegalArgumentException.class, () -> FollowedRobot.parse(text));
        assertTrue(refused.getMessage().startsWith("--follow: expected"), refused.getMessage());
    }

    @Test
    void thePoseIsReadFromSimRobotsAnswerAndScaled() throws IOException {
        FollowedRobot robot = FollowedRobot.parse("5550200=" + URL + ",100");
        var place = robot.placeIn("{\"name\":\"robot\",\"x\":-1.2500,\"y\":3.0000,\"odometry\":{\"x\":9,\"y\":9}}");
        assertEquals(-125, place.xMetres());
        assertEquals(300, place.yMetres());
        assertThrows(IOException.class, () -> robot.placeIn("<html>"));
    }
}
