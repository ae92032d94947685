package simgsm.center.demo;

import simgsm.ui.window.WindowPlace;

/**
 * The demo's three windows on one screen: the phone at the left in its own size, SimRobot and the centre share the rest,
 * side by side where that leaves each a useful width, else one above the other. On a small screen everything is smaller.
 */
record DemoLayout(WindowPlace phone, WindowPlace robot, WindowPlace center, int zoomPercent) {
    /** The phone's width with its frame. */
    private static final int PHONE_WIDTH = 336;

    private static final int SIDE_BY_SIDE_WIDTH = 1_500;
    private static final int ROBOT_WIDTH = 1_180;
    private static final int ROBOT_HEIGHT = 860;
    private static final int CENTER_WIDTH = 980;
    private static final int LEAST_CENTER_WIDTH = 800;
    private static final int CENTER_HEIGHT = 720;
    private static final double ROBOT_SHARE_OF_HEIGHT = 0.58;

    /** What the windows need at their normal size, one above the other beside the phone. */
    private static final int NEEDED_WIDTH = 1_310;

    private static final int NEEDED_HEIGHT = 860;
    private static final int LEAST_ZOOM_PERCENT = 50;
    private static final int ZOOM_STEP_PERCENT = 5;

    /** @param area usable area of the screen */
    static DemoLayout of(WindowPlace area) {
        WindowPlace phone = new WindowPlace(area.x(), area.y(), 0, 0);
        int zoom = zoomPercent(area);
        int phoneWidth = (int) Math.ceil(PHONE_WIDTH * zoom / 100.0);
        int left = area.x() + phoneWidth;
        int width = Math.max(1, area.width() - phoneWidth);
        if (width >= SIDE_BY_SIDE_WIDTH) {
            int centerWidth = Math.max(LEAST_CENTER_WIDTH, Math.min(CENTER_WIDTH, width - ROBOT_WIDTH));
            int robotWidth = Math.min(ROBOT_WIDTH, width - centerWidth);
            return new DemoLayout(
                    phone,
                    new WindowPlace(left, area.y(), robotWidth, Math.min(ROBOT_HEIGHT, area.height())),
                    new WindowPlace(left + robotWidth, area.y(), centerWidth, Math.min(CENTER_HEIGHT, area.height())),
                    zoom);
        }
        int robotHeight = Math.max(1, (int) (area.height() * ROBOT_SHARE_OF_HEIGHT));
        return new DemoLayout(
                phone,
                new WindowPlace(left, area.y(), width, robotHeight),
                new WindowPlace(left, area.y() + robotHeight, width, Math.max(1, area.height() - robotHeight)),
                zoom);
    }

    private static int zoomPercent(WindowPlace area) {
        int fits = Math.min(area.width() * 100 / NEEDED_WIDTH, area.height() * 100 / NEEDED_HEIGHT);
        int step = fits / ZOOM_STEP_PERCENT * ZOOM_STEP_PERCENT;
        return Math.max(LEAST_ZOOM_PERCENT, Math.min(100, step));
    }
}
