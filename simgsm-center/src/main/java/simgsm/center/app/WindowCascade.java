package simgsm.center.app;

import simgsm.ui.window.WindowPlace;

/**
 * Where the windows of programs go that the operator starts: phones down from the top left corner, robots down from the top
 * right, each a step further than the one before, so that none hides another.
 */
final class WindowCascade {
    private static final int STEP = 36;
    private static final int STEPS = 10;
    /** A robot's window with its frame. */
    private static final int ROBOT_WIDTH = 1_130;

    private final WindowPlace area;
    private int phones;
    private int robots;

    /** @param area what of the screen may be covered */
    WindowCascade(WindowPlace area) {
        this.area = area;
    }

    WindowPlace nextPhone() {
        int step = ++phones % STEPS * STEP;
        return new WindowPlace(area.x() + step, area.y() + step, 0, 0);
    }

    WindowPlace nextRobot() {
        int step = ++robots % STEPS * STEP;
        int x = Math.max(area.x(), area.x() + area.width() - ROBOT_WIDTH - step);
        return new WindowPlace(x, area.y() + step, 0, 0);
    }
}
