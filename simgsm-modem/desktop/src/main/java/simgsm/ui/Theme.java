package simgsm.ui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.Insets;
import java.awt.Stroke;
import java.awt.Window;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.border.Border;
import javax.swing.border.EmptyBorder;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;

/**
 * Colours, fonts, strokes and distances of the windows, at the window's appearance and zoom. Components read them
 * when painting, so a change of appearance or zoom needs only {@link #refresh}.
 *
 * <p>Distances are in design units, on a grid of 8 (4 inside controls); {@link #px} multiplies them by the zoom into
 * logical pixels. The JRE applies the display's scale.
 *
 * <p>A program has one window, so appearance and zoom are static. They are set on the event thread. The zoom is read
 * there only; the appearance is read by any thread that draws a picture for a file.
 */
public final class Theme {
    /** The step of the layout grid, in units. */
    public static final int GRID = 8;
    /** The step inside controls, in units. */
    public static final int HALF = 4;
    /** Corner radius of cards, in units. */
    public static final int CARD_RADIUS = 8;
    /** Corner radius of phone keys, in units. */
    public static final int KEY_RADIUS = 12;
    /** Corner radius of buttons, fields and chips, in units. */
    public static final int CONTROL_RADIUS = 6;

    public static final double ZOOM_MIN = 0.5;
    public static final double ZOOM_MAX = 3.0;
    private static final double ZOOM_STEP = 1.1;

    private static final double BASE_POINTS = 13;
    private static final double SMALL_POINTS = 11;
    private static final double TITLE_POINTS = 15;

    private static volatile Appearance appearance = Appearance.LIGHT;
    private static double zoom = 1;

    private Theme() {}

    public static Appearance appearance() {
        return appearance;
    }

    public static double zoom() {
        return zoom;
    }

    /** Installs the look for this program. Windows that are already open need {@link #refresh} afterwards. */
    public static void install(Appearance newAppearance) {
        install(newAppearance, zoom);
    }

    /** Sets the zoom, limited to its bounds. Windows that are already open need {@link #refresh} afterwards. */
    public static void zoomTo(double newZoom) {
        install(appearance, newZoom);
    }

    /** Installs the look at a zoom, limited to its bounds. */
    public static void install(Appearance newAppearance, double newZoom) {
        appearance = newAppearance;
        zoom = Math.max(ZOOM_MIN, Math.min(ZOOM_MAX, newZoom));
        reinstall();
    }

    /** The current zoom changed by a number of steps of 10 %. */
    public static double zoomed(int steps) {
        return Math.round(zoom * Math.pow(ZOOM_STEP, steps) * 100) / 100.0;
    }

    private static void reinstall() {
        try {
            UIManager.setLookAndFeel(new InstrumentLookAndFeel());
        } catch (UnsupportedLookAndFeelException impossible) {
            throw new IllegalStateException("Nimbus is part of every JDK's desktop module", impossible);
        }
    }

    /** Updates a tree of components after a change of appearance or zoom. */
    public static void refresh(Component root) {
        SwingUtilities.updateComponentTreeUI(root);
        if (!(root instanceof Window)) {
            root.revalidate();
        }
        root.repaint();
    }

    public static Color color(Ink ink) {
        return new Color(ink.rgb(appearance));
    }

    /** @param opacity 0 (invisible) to 1 */
    public static Color color(Ink ink, double opacity) {
        return color(ink, appearance, opacity);
    }

    static Color color(Ink ink, Appearance in, double opacity) {
        return new Color(ink.rgb(in) | (int) Math.round(opacity * 255) << 24, true);
    }

    /** Applies a style to a component now and after every {@link #refresh}. */
    public static <C extends JComponent> C styled(C component, Consumer<C> style) {
        style.accept(component);
        component.addPropertyChangeListener("UI", change -> style.accept(component));
        return component;
    }

    /** A label with a font and a colour of the theme. */
    public static JLabel label(String text, Supplier<Font> font, Ink ink) {
        return styled(new JLabel(text), label -> {
            label.setFont(font.get());
            label.setForeground(color(ink));
        });
    }

    /** Logical pixels for a distance in units at the current zoom; at least 1 for any distance above 0. */
    public static int px(double units) {
        long pixels = Math.round(units * zoom);
        return (int) (units > 0 ? Math.max(1, pixels) : pixels);
    }

    /** Logical pixels for a distance in units at the current zoom, not rounded; for painters. */
    public static float exact(double units) {
        return (float) (units * zoom);
    }

    /** The font of text and labels. */
    public static Font base() {
        return sans(BASE_POINTS, false);
    }

    public static Font strong() {
        return sans(BASE_POINTS, true);
    }

    public static Font small() {
        return sans(SMALL_POINTS, false);
    }

    public static Font title() {
        return sans(TITLE_POINTS, true);
    }

    /** The font of numbers, keys and orders. */
    public static Font mono() {
        return mono(BASE_POINTS, false);
    }

    public static Font monoStrong() {
        return mono(BASE_POINTS, true);
    }

    public static Font monoSmall() {
        return mono(SMALL_POINTS, false);
    }

    /** A monospaced face of another size in units, for displays and keys. */
    public static Font mono(double points, boolean bold) {
        return font(true, bold, points * zoom);
    }

    /** A sans-serif face of another size in units. */
    public static Font sans(double points, boolean bold) {
        return font(false, bold, points * zoom);
    }

    /** A font of a size in pixels, independent of the zoom. */
    static Font font(boolean monospaced, boolean bold, double pixels) {
        return new Font(monospaced ? Font.MONOSPACED : Font.SANS_SERIF, bold ? Font.BOLD : Font.PLAIN, 1)
                .deriveFont((float) pixels);
    }

    /** The stroke of rules and borders. */
    public static Stroke hairline() {
        return stroke(1);
    }

    /** The stroke of signals, icons and focus rings. */
    public static Stroke line() {
        return stroke(1.6);
    }

    /** A round stroke of a width in units. */
    public static Stroke stroke(double units) {
        return stroke(exact(units), 0);
    }

    /** A dashed stroke. @param dash length of each dash and gap, in units */
    public static Stroke dashed(double units, double dash) {
        return stroke(exact(units), exact(dash));
    }

    /** @param dash length of each dash and gap in pixels; 0 for a solid line with round ends */
    static Stroke stroke(double pixels, double dash) {
        return dash == 0
                ? new BasicStroke((float) pixels, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
                : new BasicStroke(
                        (float) pixels, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {(float) dash}, 0);
    }

    /** Empty space around a component, in units; follows the zoom. */
    public static Border padding(int top, int left, int bottom, int right) {
        return new EmptyBorder(top, left, bottom, right) {
            @Override
            public Insets getBorderInsets(Component c, Insets insets) {
                insets.set(px(top), px(left), px(bottom), px(right));
                return insets;
            }
        };
    }

    public static Border padding(int units) {
        return padding(units, units, units, units);
    }
}
