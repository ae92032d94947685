package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.ui.window.SuiteWindow;
import simgsm.ui.window.WindowPlace;

class WindowCascadeTest {
    private static final WindowPlace SCREEN = new WindowPlace(10, 20, 1_600, 1_000);

    @Test
    void noTwoOfTenWindowsLieOnOneAnother() {
        WindowCascade cascade = new WindowCascade(SCREEN);
        Set<WindowPlace> places = new HashSet<>();
        for (int i = 0; i < 10; i++) {
            WindowPlace phone = cascade.nextPhone();
            assertTrue(phone.x() >= 10 && phone.y() >= 20, phone.toString());
            places.add(phone);
        }
        assertEquals(10, places.size());
    }

    @Test
    void robotsComeFromTheRightButNeverLieBeyondTheLeftEdge() {
        assertEquals(
                1_610 - 1_130 - 36,
                new WindowCascade(SCREEN).nextRobot(Optional.empty(), 1).x());
        assertEquals(
                0,
                new WindowCascade(new WindowPlace(0, 0, 1_000, 700))
                        .nextRobot(Optional.empty(), 1)
                        .x());
    }

    /** The demo's places on 1366x768, 1920x1080 and 3840x2160. */
    @ParameterizedTest
    @CsvSource({"338,16,1028,449,1", "338,0,1582,710,1.2", "660,0,3180,1400,2"})
    void moreRobotsLieOverTheFirstOneAndLeavePhoneAndCentreInView(int x, int y, int width, int height, double zoom) {
        WindowPlace first = new WindowPlace(x, y, width, height);
        WindowCascade cascade = new WindowCascade(SCREEN);
        for (int i = 0; i < 20; i++) {
            WindowPlace next = cascade.nextRobot(Optional.of(first), zoom);
            assertTrue(next.x() > x && next.y() >= y, next.toString());
            assertEquals(x + width, next.x() + next.width());
            assertEquals(y + height, next.y() + next.height());
            assertTrue(next.width() >= SuiteWindow.ROBOT.widthUnits() * zoom, next.toString());
            assertTrue(next.height() >= Math.min(height, SuiteWindow.ROBOT.heightUnits() * zoom), next.toString());
        }
    }
}
