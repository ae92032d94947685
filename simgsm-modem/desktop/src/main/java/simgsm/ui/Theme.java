package simgsm.ui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.Insets;
import java.awt.Stroke;
import java.awt.Window;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.border.Border;

/**
 * The one place that names colours, fonts, strokes and distances. Everything else asks here, at the moment it paints,
 * so that a change of appearance or zoom needs nothing but {@link #refresh}.
 *
 * <p>Distances are written in units of the design, on a grid of 8 (4 inside controls), and become logical pixels by
 * {@link #px}, which applies the zoom. The display's own scale is the JRE's business.
 *
 * <p>One program has one window, so appearance and zoom belong to the program. Touched on the event thread only.
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

    private static Appearance appearance = Appearance.LIGHT;
    private static double zoom = 1;

    private Theme() {}

    /** A colour by its task. The pairs that carry text have a contrast of at least 4.5 to 1 in both appearances. */
    public enum Ink {
        /** What windows are made of. */
        SURFACE(0xF6F7F9, 0x1E2126),
        /** What lies on the surface and carries content. */
        CARD(0xFFFFFF, 0x272B31),
        /** Borders and rules. */
        LINE(0xD5D9E0, 0x3B4149),
        /** Borders of things that can be used; 3 to 1 against the card. */
        CONTROL_LINE(0x848D9A, 0x79828D),
        TEXT(0x1B1F24, 0xE8EAED),
        QUIET(0x5B6470, 0xA6AEB8),
        DISABLED(0x99A1AC, 0x6C747E),
        ACCENT(0x1F5FBF, 0x7FB0FF),
        /** Text on the accent. */
        ON_ACCENT(0xFFFFFF, 0x10141A),
        /** A thin wash of the accent: selections, the lit part of a track. */
        ACCENT_WASH(0xDFE9F8, 0x2C3B53),
        GOOD(0x1E7F4F, 0x5CC890),
        GOOD_WASH(0xE2F3EA, 0x233A2F),
        WARNING(0x9A6200, 0xF0B64A),
        WARNING_WASH(0xFBF1DE, 0x3C3321),
        DANGER(0xB3261E, 0xFF8A80),
        DANGER_WASH(0xFBE6E4, 0x452B2B),
        /** Text on a filled good or danger key. */
        ON_SIGNAL(0xFFFFFF, 0x10141A),
        HOVER(0xEDF0F4, 0x30353C),
        PRESSED(0xDDE2E9, 0x3A4048),

        /** The handset's body, its keys' faces and their lower edge. */
        BODY(0xDCE1E8, 0x2D3239),
        BODY_LINE(0xB4BCC7, 0x4A515B),
        KEY_FACE(0xFDFDFE, 0x3A4048),
        CALL_FACE(0x1E7F4F, 0x278052),
        END_FACE(0xB3261E, 0xC03A30),
        /** Signs on those two. */
        ON_FACE(0xFFFFFF, 0xFFFFFF),
        KEY_LINE(0xAAB3BF, 0x565E69),
        KEY_HOVER(0xF0F3F7, 0x434A53),
        /** The display of the phone: the same in both appearances, as a real one is. */
        LCD_PAPER(0xB9C9A3, 0xB9C9A3),
        LCD_INK(0x20301A, 0x20301A),
        LCD_QUIET(0x3F5236, 0x3F5236),
        /** Segments that are not driven, just to be seen. */
        LCD_GHOST(0xA6B78F, 0xA6B78F),
        LCD_RIM(0x5E6B50, 0x10130E),

        /** The world view: floor, grid, walls, robot. */
        FLOOR(0xFCFCFA, 0x22262B),
        GRID_LINE(0xE9ECEF, 0x2C3137),
        GRID_MAJOR(0xD5D9E0, 0x3B4149),
        WALL(0x2B3037, 0xCDD3DA),
        ROBOT(0xC2402F, 0xE2705C),
        ROBOT_LINE(0x5C160E, 0xFFD9D2),
        WHEEL(0x23272D, 0x14171B),
        TRAIL(0x1F5FBF, 0x7FB0FF),
        RAY(0x9A6200, 0xF0B64A);

        private final Color light;
        private final Color dark;

        Ink(int light, int dark) {
            this.light = new Color(light);
            this.dark = new Color(dark);
        }

        /** The colour in the present appearance. */
        public Color color() {
            return in(appearance);
        }

        public Color in(Appearance appearance) {
            return appearance == Appearance.LIGHT ? light : dark;
        }

        /** The colour, see-through. @param opacity 0 (nothing to be seen) to 1 */
        public Color color(double opacity) {
            Color solid = color();
            return new Color(solid.getRed(), solid.getGreen(), solid.getBlue(), (int) Math.round(opacity * 255));
        }
    }

    public static Appearance appearance() {
        return appearance;
    }

    public static double zoom() {
        return zoom;
    }

    /** Installs the look for this program. Windows that are already open need {@link #refresh} afterwards. */
    public static void install(Appearance newAppearance) {
        appearance = newAppearance;
        reinstall();
    }

    /** Sets the zoom, kept within its bounds. Windows that are already open need {@link #refresh} afterwards. */
    public static void zoomTo(double newZoom) {
        zoom = Math.max(ZOOM_MIN, Math.min(ZOOM_MAX, newZoom));
        reinstall();
    }

    static void zoomBy(int steps) {
        zoomTo(Math.round(zoom * Math.pow(ZOOM_STEP, steps) * 100) / 100.0);
    }

    private static void reinstall() {
        try {
            UIManager.setLookAndFeel(new InstrumentLookAndFeel());
        } catch (UnsupportedLookAndFeelException impossible) {
            throw new IllegalStateException("Nimbus is part of every JDK's desktop module", impossible);
        }
    }

    /** Lets a whole tree of components take over the present appearance and zoom. */
    public static void refresh(Component root) {
        SwingUtilities.updateComponentTreeUI(root);
        if (!(root instanceof Window)) {
            root.revalidate();
        }
        root.repaint();
    }

    /** Logical pixels for a distance in units, at the present zoom; at least 1 for anything above 0. */
    public static int px(double units) {
        long pixels = Math.round(units * zoom);
        return (int) (units > 0 ? Math.max(1, pixels) : pixels);
    }

    /** The same without rounding, for painters. */
    public static float exact(double units) {
        return (float) (units * zoom);
    }

    /** Text and labels. */
    public static Font base() {
        return font(Font.SANS_SERIF, Font.PLAIN, BASE_POINTS);
    }

    public static Font strong() {
        return font(Font.SANS_SERIF, Font.BOLD, BASE_POINTS);
    }

    public static Font small() {
        return font(Font.SANS_SERIF, Font.PLAIN, SMALL_POINTS);
    }

    public static Font title() {
        return font(Font.SANS_SERIF, Font.BOLD, TITLE_POINTS);
    }

    /** Numbers, keys, orders. */
    public static Font mono() {
        return font(Font.MONOSPACED, Font.PLAIN, BASE_POINTS);
    }

    public static Font monoStrong() {
        return font(Font.MONOSPACED, Font.BOLD, BASE_POINTS);
    }

    public static Font monoSmall() {
        return font(Font.MONOSPACED, Font.PLAIN, SMALL_POINTS);
    }

    /** A monospaced face of another size, for displays and keys. */
    public static Font mono(double points, boolean bold) {
        return font(Font.MONOSPACED, bold ? Font.BOLD : Font.PLAIN, points);
    }

    /** A text face of another size. */
    public static Font sans(double points, boolean bold) {
        return font(Font.SANS_SERIF, bold ? Font.BOLD : Font.PLAIN, points);
    }

    private static Font font(String family, int style, double points) {
        return new Font(family, style, 1).deriveFont((float) (points * zoom));
    }

    /** Rules and borders. */
    public static Stroke hairline() {
        return stroke(1);
    }

    /** Signals, icons, focus rings. */
    public static Stroke line() {
        return stroke(1.6);
    }

    /** A round stroke of a width in units. */
    public static Stroke stroke(double units) {
        return new BasicStroke(exact(units), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** A dashed stroke. @param dash length of dash and gap, in units */
    public static Stroke dashed(double units, double dash) {
        return new BasicStroke(
                exact(units), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {exact(dash)}, 0);
    }

    /** Empty space around a component, in units; follows the zoom. */
    public static Border padding(int top, int left, int bottom, int right) {
        return new Padding(top, left, bottom, right);
    }

    public static Border padding(int units) {
        return new Padding(units, units, units, units);
    }

    static Insets insets(int top, int left, int bottom, int right) {
        return new Insets(px(top), px(left), px(bottom), px(right));
    }
}
