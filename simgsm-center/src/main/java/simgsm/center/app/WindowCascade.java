package simgsm.center.app;

import simgsm.ui.window.WindowPlace;

/**
 * Places of the windows of started programs: phones from the top left corner, robots from the top right, each 36 pixels
 * further down and inwards than the one before.
 */
final class WindowCascade {
    private static final int STEP = 36;
    private static final int STEPS = 10;
    /** Of a robot's window with its frame, in pixels. */
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

    WindowPlace nextRobot() {
        int step = ++robots % STEPS * STEP;
        int x = Math.max(area.x(), area.x() + area.width() - ROBOT_WIDTH - step);
        return new WindowPlace(x, area.y() + step, 0, 0);
    }
}
