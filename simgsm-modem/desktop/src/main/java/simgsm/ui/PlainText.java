package simgsm.ui;

import javax.swing.JComponent;

/** Text from outside in a component of Swing, which otherwise reads a text that begins with {@code <html>} as markup. */
public final class PlainText {
    private PlainText() {}

    /** Lets a component show every text as it is, and load no picture. */
    public static <T extends JComponent> T in(T component) {
        component.putClientProperty("html.disable", true);
        return component;
    }
}
