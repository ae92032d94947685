package simgsm.center.app;

import java.util.Optional;
import simgsm.ui.window.SuiteWindow;
import simgsm.ui.window.WindowPlace;

/**
 * Places of the windows of started programs, each 36 pixels below and to the right or left of the last: phones from the
 * top left corner; robots over the first one, so that phone and centre remain visible, or from the top right without
 * one.
 */
final class WindowCascade {
    private static final int STEP = 36;
    private static final int STEPS = 10;
    /** Width of a robot's window with its frame, in pixels. */
    private static final int ROBOT_WIDTH = 1_130;

    private final WindowPlace area;
    private int phones;
    private int robots;

    /** @param area usable area of the screen */
    WindowCascade(WindowPlace area) {
        this.area = area;
    }

    WindowPlace nextPhone() {
        int step = ++phones % STEPS * STEP;
        return new WindowPlace(area.x() + step, area.y() + step, 0, 0);
    }

    /** @param first the place of the running SimRobot; the new one has the same right and lower edge */
    WindowPlace nextRobot(Optional<WindowPlace> first, double zoom) {
        return first.filter(place -> place.width() > 0)
                .map(place -> over(place, zoom))
                .orElseGet(this::nextRobot);
    }

    private WindowPlace over(WindowPlace first, double zoom) {
        int down = inwards(first.height(), SuiteWindow.ROBOT.heightUnits() * zoom);
        int right = inwards(first.width(), SuiteWindow.ROBOT.widthUnits() * zoom);
        robots++;
        return new WindowPlace(first.x() + right, first.y() + down, first.width() - right, first.height() - down);
    }

    /** Steps inwards while the minimum length remains; then restarts. */
    private int inwards(int length, double least) {
        int steps = Math.min(STEPS, Math.max(0, (int) ((length - least) / STEP)));
        return steps == 0 ? 0 : (robots % steps + 1) * STEP;
    }

    private WindowPlace nextRobot() {
        int step = ++robots % STEPS * STEP;
        int x = Math.max(area.x(), area.x() + area.width() - ROBOT_WIDTH - step);
        return new WindowPlace(x, area.y() + step, 0, 0);
    }
}
