package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
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
        assertEquals(1_610 - 1_130 - 36, new WindowCascade(SCREEN).nextRobot().x());
        assertEquals(
                0,
                new WindowCascade(new WindowPlace(0, 0, 1_000, 700)).nextRobot().x());
    }
}
