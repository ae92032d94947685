package simgsm.center.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.ui.window.WindowPlace;

class DemoLayoutTest {
    @ParameterizedTest
    @CsvSource({"1024, 768", "1280, 800", "1366, 768", "1600, 1000", "1920, 1080", "2560, 1440", "3840, 2160"})
    void noWindowCoversAnotherOrLeavesTheScreen(int width, int height) {
        DemoLayout layout = DemoLayout.of(new WindowPlace(10, 20, width, height));
        WindowPlace robot = layout.robot();
        WindowPlace center = layout.center();
        assertEquals("10,20", layout.phone().toString());
        assertTrue(robot.x() >= 10 + 320 * layout.zoomPercent() / 100, "the phone stands free");
        assertTrue(center.width() >= 970 * layout.zoomPercent() / 100 || width >= 1900, "room for the centre");
        assertTrue(robot.height() >= 480 * layout.zoomPercent() / 100, "room for the robot");
        assertTrue(
                robot.x() + robot.width() <= center.x() || robot.y() + robot.height() <= center.y(),
                robot + " and " + center);
        for (WindowPlace place : new WindowPlace[] {robot, center}) {
            assertTrue(place.x() + place.width() <= 10 + width, place + " on " + width);
            assertTrue(place.y() + place.height() <= 20 + height, place + " on " + height);
        }
    }

    @Test
    void whereThereIsRoomEachHasItsOwnSize() {
        DemoLayout layout = DemoLayout.of(new WindowPlace(0, 0, 2560, 1440));
        assertEquals(100, layout.zoomPercent());
        assertEquals("336,0,1180,860", layout.robot().toString());
        assertEquals("1516,0,980,720", layout.center().toString());
    }
}
