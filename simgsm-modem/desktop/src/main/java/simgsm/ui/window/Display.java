package simgsm.ui.window;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Rectangle;

/** The screen, if there is one. */
public final class Display {
    private Display() {}

    /**
     * Whether a window could be shown. A display that is named but cannot be reached is none, and neither is any to a
     * Java that came without its desktop's libraries.
     */
    public static boolean isThere() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | NoClassDefFoundError | UnsatisfiedLinkError none) {
            return false;
        }
    }

    /** The part of the main screen that no task bar covers. */
    public static WindowPlace usableArea() {
        Rectangle area = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        return new WindowPlace(area.x, area.y, area.width, area.height);
    }
}
