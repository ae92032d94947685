package simgsm.ui.window;

import java.awt.Dimension;
import javax.swing.JFrame;

/**
 * A place on the screen: {@code X,Y} or {@code X,Y,WIDTH,HEIGHT}, in pixels.
 *
 * @param width 0, like {@code height}, for the window's own size
 */
public record WindowPlace(int x, int y, int width, int height) {
    private static final String COORDINATE = "-?[0-9]{1,5}";
    private static final String LENGTH = "[1-9][0-9]{0,4}";

    /** Reads the value of {@code --window}; IllegalArgumentException names the expected form. */
    public static WindowPlace parse(String text) {
        if (!text.matches(COORDINATE + "," + COORDINATE + "(," + LENGTH + "," + LENGTH + ")?")) {
            throw new IllegalArgumentException("expected X,Y or X,Y,WIDTH,HEIGHT, found " + text);
        }
        String[] parts = text.split(",");
        boolean isSized = parts.length == 4;
        return new WindowPlace(
                Integer.parseInt(parts[0]),
                Integer.parseInt(parts[1]),
                isSized ? Integer.parseInt(parts[2]) : 0,
                isSized ? Integer.parseInt(parts[3]) : 0);
    }

    /** Moves and resizes a window, not below its minimum size. */
    public void applyTo(JFrame frame) {
        if (width > 0) {
            Dimension least = frame.getMinimumSize();
            frame.setSize(Math.max(width, least.width), Math.max(height, least.height));
        }
        frame.setLocation(x, y);
    }

    /** In the form read by {@link #parse}. */
    @Override
    public String toString() {
        return x + "," + y + (width > 0 ? "," + width + "," + height : "");
    }
}
