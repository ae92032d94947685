package simgsm.classroom.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.ui.window.SuiteWindow;
import simgsm.ui.window.WindowPlace;

class DemoLayoutTest {
    private static Stream<Arguments> screensAndZooms() {
        List<int[]> screens = List.of(
                new int[] {1024, 768},
                new int[] {1280, 720},
                new int[] {1366, 768},
                new int[] {1600, 1000},
                new int[] {1920, 1080},
                new int[] {2560, 1440},
                new int[] {3840, 2160});
        return screens.stream()
                .flatMap(screen -> Stream.of(0, 100, 125, 150, 175, 200)
                        .map(zoom -> Arguments.of(
                                screen[0], screen[1], zoom == 0 ? OptionalInt.empty() : OptionalInt.of(zoom))));
    }

    @ParameterizedTest
    @MethodSource("screensAndZooms")
    void noWindowMeetsAnotherOrLeavesTheScreenAndEachHasItsLeastSize(int width, int height, OptionalInt zoom) {
        DemoLayout layout = DemoLayout.of(new WindowPlace(10, 20, width, height), zoom);
        double scale = layout.zoomPercent() / 100.0;
        Rectangle phone = new Rectangle(
                layout.phone().x(), layout.phone().y(), (int) (SuiteWindow.PHONE.widthUnits() * scale), (int)
                        (SuiteWindow.PHONE.heightUnits() * scale));
        Rectangle robot = rectangle(layout.robot());
        Rectangle center = rectangle(layout.center());
        assertFalse(phone.intersects(robot), phone + " meets " + robot);
        assertFalse(phone.intersects(center), phone + " meets " + center);
        assertFalse(robot.intersects(center), robot + " meets " + center);
        for (Rectangle window : List.of(phone, robot, center)) {
            assertTrue(new Rectangle(10, 20, width, height).contains(window), window + " leaves the screen");
        }
        assertHolds(robot, SuiteWindow.ROBOT, scale);
        assertHolds(center, SuiteWindow.CENTER, scale);
    }

    private static void assertHolds(Rectangle place, SuiteWindow window, double scale) {
        assertTrue(place.width >= (int) (window.widthUnits() * scale), window + " in " + place);
        assertTrue(place.height >= (int) (window.heightUnits() * scale), window + " in " + place);
    }

    private static Rectangle rectangle(WindowPlace place) {
        return new Rectangle(place.x(), place.y(), place.width(), place.height());
    }

    @ParameterizedTest
    @CsvSource({"1366, 768, 100", "1600, 1000, 110", "1920, 1080, 120", "2560, 1440, 160", "3840, 2160, 200"})
    void aLargerScreenHasALargerZoom(int width, int height, int percent) {
        assertEquals(
                percent,
                DemoLayout.of(new WindowPlace(0, 0, width, height), OptionalInt.empty())
                        .zoomPercent());
    }

    @Test
    void aZoomThatFitsIsUsedAsGiven() {
        WindowPlace screen = new WindowPlace(0, 0, 1920, 1080);
        assertEquals(100, DemoLayout.of(screen, OptionalInt.of(100)).zoomPercent());
        assertEquals(150, DemoLayout.of(screen, OptionalInt.of(150)).zoomPercent());
        assertTrue(DemoLayout.of(screen, OptionalInt.of(200)).zoomPercent() >= 150);
    }
}
