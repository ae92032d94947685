package simgsm.ui.window;

import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;

/** Keeps windows on the screen on which they stand, beside its task bars. */
public final class ScreenArea {
    private ScreenArea() {}

    /** Gives a window this size as far as there is room, and moves it as far as it must be moved for that. */
    public static void resize(Window window, int width, int height) {
        Rectangle wanted = new Rectangle(window.getX(), window.getY(), width, height);
        window.setBounds(within(wanted, room(window.getGraphicsConfiguration())));
    }

    private static Rectangle room(GraphicsConfiguration screen) {
        Rectangle all = screen.getBounds();
        Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(screen);
        return new Rectangle(
                all.x + bars.left,
                all.y + bars.top,
                all.width - bars.left - bars.right,
                all.height - bars.top - bars.bottom);
    }

    /** The wanted place, moved into the room and cut to it where it is too large; what was outside before may stay so. */
    static Rectangle within(Rectangle wanted, Rectangle room) {
        int width = Math.min(wanted.width, room.width);
        int height = Math.min(wanted.height, room.height);
        int x = Math.min(wanted.x, Math.max(room.x, room.x + room.width - width));
        int y = Math.min(wanted.y, Math.max(room.y, room.y + room.height - height));
        return new Rectangle(x, y, width, height);
    }
}
