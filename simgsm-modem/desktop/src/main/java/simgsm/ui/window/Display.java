package simgsm.ui.window;

import java.awt.AWTError;
import java.awt.Component;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** The screen. */
public final class Display {
    private Display() {}

    /** True if a window can be shown: the named display can be reached, and the JRE has desktop libraries. */
    public static boolean isAvailable() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | NoClassDefFoundError | UnsatisfiedLinkError e) {
            return false;
        }
    }

    /** The part of the main screen without task bars. */
    public static WindowPlace usableArea() {
        Rectangle area = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        return new WindowPlace(area.x, area.y, area.width, area.height);
    }

    /** The bounds of all screens. */
    static List<WindowPlace> screens() {
        return Stream.of(GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices())
                .map(screen -> screen.getDefaultConfiguration().getBounds())
                .map(area -> new WindowPlace(area.x, area.y, area.width, area.height))
                .toList();
    }

    /** Resizes a window, limited to its screen without task bars, and moves it as far as necessary. */
    public static void resize(Window window, int width, int height) {
        place(window, new Rectangle(window.getX(), window.getY(), width, height));
    }

    /** Gives a window these bounds, limited in the same way. */
    static void place(Window window, Rectangle wanted) {
        window.setBounds(within(wanted, usableArea(window)));
    }

    /** The window's screen without task bars. */
    public static Rectangle usableArea(Window window) {
        GraphicsConfiguration screen = window.getGraphicsConfiguration();
        Rectangle area = screen.getBounds();
        Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(screen);
        area.x += bars.left;
        area.y += bars.top;
        area.width -= bars.left + bars.right;
        area.height -= bars.top + bars.bottom;
        return area;
    }

    /** Maximizes the frame around a component, or restores its size. */
    public static void maximize(Component inside, boolean wanted) {
        if (SwingUtilities.getWindowAncestor(inside) instanceof JFrame frame) {
            frame.setExtendedState(wanted ? JFrame.MAXIMIZED_BOTH : JFrame.NORMAL);
        }
    }

    /** The wanted bounds, cut to the area's size and moved into it; they may begin to the left of it. */
    static Rectangle within(Rectangle wanted, Rectangle area) {
        int width = Math.min(wanted.width, area.width);
        int height = Math.min(wanted.height, area.height);
        int x = Math.min(wanted.x, area.x + area.width - width);
        int y = Math.max(area.y, Math.min(wanted.y, area.y + area.height - height));
        return new Rectangle(x, y, width, height);
    }
}
