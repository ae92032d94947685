package simgsm.ui;

import javax.swing.JComponent;

/**
 * Text from outside in a Swing component, which by default reads a text that begins with {@code <html>} as markup.
 */
public final class PlainText {
    private PlainText() {}

    /** Makes a component show every text literally, and load no picture. */
    public static <T extends JComponent> T in(T component) {
        component.putClientProperty("html.disable", true);
        return component;
    }
}
