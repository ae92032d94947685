package simgsm.classroom.demo;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import simgsm.console.Arguments;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.SuiteWindow;
import simgsm.ui.window.WindowPlace;

/**
 * The demo's three windows on one screen: the phone at the left in its natural size, SimRobot at its right, the centre
 * below SimRobot. Windows do not overlap or leave the screen, and the world takes at least a fifth of the screen.
 */
public record DemoLayout(WindowPlace phone, WindowPlace robot, WindowPlace center, int zoomPercent) {
    private static final System.Logger LOG = System.getLogger(DemoLayout.class.getName());
    /** Comfortable width at 100 %; a larger screen gets a larger zoom. */
    private static final int COMFORTABLE_WIDTH = 1_340;

    private static final int COMFORTABLE_HEIGHT = 900;
    private static final int LEAST_ZOOM_PERCENT = 50;
    private static final int NORMAL_ZOOM_PERCENT = 100;
    private static final int MOST_ZOOM_PERCENT = 200;
    private static final int ZOOM_STEP_PERCENT = 5;

    private static final double CENTER_SHARE_OF_HEIGHT = 0.42;
    private static final double WORLD_SHARE_OF_SCREEN = 0.2;

    // Space around the world in SimRobot's window for frame, margins, tools, modem and VeriCommand, in units.
    private static final int MARGINS_WIDTH = 20;
    private static final int TOOLS_HEIGHT = 114;
    private static final int COLUMN_WIDTH = 320;
    private static final int ROW_HEIGHT = 166;
    /** Height of a window's frame beyond the phone's minimum height. */
    private static final int FRAME_UNITS = 24;

    /**
     * Places the windows.
     *
     * @param area usable area of the screen
     * @param wantedPercent the requested zoom; reduced to the largest one that fits
     */
    public static DemoLayout of(WindowPlace area, OptionalInt wantedPercent) {
        int wanted = wantedPercent.orElse(comfortablePercent(area));
        int zoom = wanted;
        while (zoom > LEAST_ZOOM_PERCENT && !fits(area, zoom)) {
            zoom = Math.max(LEAST_ZOOM_PERCENT, (zoom - 1) / ZOOM_STEP_PERCENT * ZOOM_STEP_PERCENT);
        }
        return at(area, zoom);
    }

    /** With as much height for the world as the centre can leave. */
    DemoLayout withFlatCenter() {
        int flat = pixels(SuiteWindow.CENTER.heightUnits(), zoomPercent);
        int gained = Math.max(0, center.height() - flat);
        return new DemoLayout(
                phone,
                new WindowPlace(robot.x(), robot.y(), robot.width(), robot.height() + gained),
                new WindowPlace(center.x(), center.y() + gained, center.width(), center.height() - gained),
                zoomPercent);
    }

    /** Warns if the command line's zoom did not fit. @return this layout */
    public DemoLayout saying(boolean isZoomGiven, OptionalInt wantedPercent) {
        if (isZoomGiven && zoomPercent < wantedPercent.getAsInt()) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "zoom {0} leaves no room for three windows on this screen; {1} is used",
                    wantedPercent.getAsInt(),
                    zoomPercent);
        }
        return this;
    }

    /** The options that place a program's window, and further ones. */
    public List<String> options(WindowPlace place, String... more) {
        return Stream.concat(
                        Stream.of("--zoom", String.valueOf(zoomPercent), "--window", place.toString()), Stream.of(more))
                .toList();
    }

    /** The part of the screen below the phone. */
    WindowPlace belowPhone(WindowPlace screen) {
        int bottom = phone.y() + phoneHeight();
        int height = Math.max(0, screen.y() + screen.height() - bottom);
        return new WindowPlace(phone.x(), bottom, robot.x() - phone.x(), height);
    }

    /** The place reserved for an unopened phone. */
    WindowPlace insteadOfPhone() {
        return new WindowPlace(phone.x(), phone.y(), robot.x() - phone.x(), phoneHeight());
    }

    /** The phone's column over the whole height of the screen. */
    public WindowPlace phoneColumn(WindowPlace screen) {
        return new WindowPlace(phone.x(), phone.y(), robot.x() - phone.x(), screen.height());
    }

    private int phoneHeight() {
        return (SuiteWindow.PHONE.heightUnits() + FRAME_UNITS) * zoomPercent / 100;
    }

    /** The window of the centre. */
    public ProgramWindow centerWindow(Arguments arguments) throws UsageException, UnavailableException {
        return ProgramWindow.of(
                arguments.with("zoom", String.valueOf(zoomPercent)).with("window", center.toString()),
                Optional.empty());
    }

    private static int comfortablePercent(WindowPlace area) {
        int percent = Math.min(area.width() * 100 / COMFORTABLE_WIDTH, area.height() * 100 / COMFORTABLE_HEIGHT);
        int step = percent / ZOOM_STEP_PERCENT * ZOOM_STEP_PERCENT;
        return Math.max(NORMAL_ZOOM_PERCENT, Math.min(MOST_ZOOM_PERCENT, step));
    }

    private static boolean fits(WindowPlace area, int zoom) {
        DemoLayout layout = at(area, zoom);
        return pixels(SuiteWindow.PHONE.heightUnits(), zoom) <= area.height()
                && holds(layout.robot, SuiteWindow.ROBOT, zoom)
                && holds(layout.center, SuiteWindow.CENTER, zoom)
                && worldPixels(layout.robot, zoom) >= WORLD_SHARE_OF_SCREEN * area.width() * area.height();
    }

    private static boolean holds(WindowPlace place, SuiteWindow window, int zoom) {
        return place.width() >= pixels(window.widthUnits(), zoom)
                && place.height() >= pixels(window.heightUnits(), zoom);
    }

    private static DemoLayout at(WindowPlace area, int zoom) {
        int left = pixels(SuiteWindow.PHONE.widthUnits(), zoom);
        int width = Math.max(1, area.width() - left);
        int least = pixels(SuiteWindow.CENTER.heightUnits(), zoom);
        int centerHeight = Math.max(least, (int) (area.height() * CENTER_SHARE_OF_HEIGHT));
        if (robotPixels(area, width, centerHeight, zoom) < WORLD_SHARE_OF_SCREEN * area.width() * area.height()) {
            centerHeight = least;
        }
        int robotHeight = Math.max(1, area.height() - centerHeight);
        int x = area.x() + left;
        return new DemoLayout(
                new WindowPlace(area.x(), area.y(), 0, 0),
                new WindowPlace(x, area.y(), width, robotHeight),
                new WindowPlace(x, area.y() + robotHeight, width, Math.max(1, area.height() - robotHeight)),
                zoom);
    }

    private static double robotPixels(WindowPlace area, int width, int centerHeight, int zoom) {
        return worldPixels(new WindowPlace(0, 0, width, Math.max(1, area.height() - centerHeight)), zoom);
    }

    /** The world's area in SimRobot's window, with modem and VeriCommand at its right or below it. */
    private static double worldPixels(WindowPlace robot, int zoom) {
        double width = robot.width() - pixels(MARGINS_WIDTH, zoom);
        double height = robot.height() - pixels(TOOLS_HEIGHT, zoom);
        double atRight = (width - pixels(COLUMN_WIDTH, zoom)) * height;
        double below = width * (height - pixels(ROW_HEIGHT, zoom));
        return Math.max(atRight, below);
    }

    private static int pixels(int units, int zoom) {
        return (int) Math.ceil(units * zoom / 100.0);
    }
}
