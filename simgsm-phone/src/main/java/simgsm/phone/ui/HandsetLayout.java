package simgsm.phone.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
import java.util.HashMap;
import java.util.Map;
import simgsm.phone.screen.PhoneKey;
import simgsm.ui.Arrange;
import simgsm.ui.Theme;

/**
 * Lays out the handset on a drawing 320 units wide and scales the drawing to the panel, centred. The open fold is
 * below the keys, or at their right if that makes the handset larger.
 */
final class HandsetLayout implements Arrange.FixedLayout {
    static final double WIDTH = 320;
    static final double CLOSED_HEIGHT = 624;

    private static final double PAD_TOP = 232;

    static final Rectangle2D WINDOW_MENU = new Rectangle2D.Double(20, 12, 30, 26);
    static final Rectangle2D LINK = new Rectangle2D.Double(58, 14, 130, 22);
    static final Rectangle2D BRAND = new Rectangle2D.Double(196, 14, 100, 22);
    static final Rectangle2D LCD = new Rectangle2D.Double(20, 44, 280, 180);
    static final Rectangle2D PAD = new Rectangle2D.Double(112, PAD_TOP, 96, 96);
    static final Rectangle2D FOOT = new Rectangle2D.Double(20, 580, 280, 28);

    private static final double FOLD_TOP = 610;
    private static final double FOLD_BELOW = 8;
    /** Width of a fold at the right of the keys. */
    private static final double BESIDE_WIDTH = 288;
    /** Least scale, relative to the zoom, at which no text is cut. */
    private static final double LEAST_SHRINKING = 0.95;

    private static final Rectangle2D BESIDE = new Rectangle2D.Double(308, 14, 280, 594);
    private static final Rectangle2D SCOPE_BESIDE = new Rectangle2D.Double(318, 24, 260, 574);
    private static final Rectangle2D EVENTS_BESIDE = new Rectangle2D.Double(314, 20, 268, 582);

    static final Rectangle2D SCOPE = new Rectangle2D.Double(30, 620, 260, 350);
    static final Rectangle2D EVENTS = new Rectangle2D.Double(26, 616, 268, 120);

    private static final double KEY_TOP = 336;
    private static final double KEY_WIDTH = 88;
    private static final double KEY_HEIGHT = 53;
    private static final double KEY_GAP = 8;
    private static final double ROW_GAP = 7;
    private static final double SIDE_WIDTH = 80;
    private static final double HALF_WIDTH = 37;
    private static final double SOFT_TOP = 231;
    private static final double SOFT_HEIGHT = 26;
    private static final double CALL_TOP = 262;
    private static final double CALL_HEIGHT = 36;
    private static final double LOWER_TOP = 303;
    private static final double LOWER_HEIGHT = 26;

    private final Map<Component, Rectangle2D> places = new HashMap<>();
    private HandsetFold fold = HandsetFold.NONE;

    void setFold(HandsetFold next) {
        fold = next;
    }

    HandsetFold fold() {
        return fold;
    }

    /** Returns true if the events below the keys take no scale from the handset. */
    boolean hasRoomForEvents(Dimension panel) {
        double needed = (CLOSED_HEIGHT + HandsetFold.EVENTS.heightUnits()) / WIDTH;
        return panel.width > 0 && panel.height >= panel.width * needed;
    }

    private double height() {
        return CLOSED_HEIGHT + fold.heightUnits();
    }

    /** True if the open fold is at the right of the keys in a panel of this size. */
    boolean isBeside(Dimension panel) {
        return fold != HandsetFold.NONE
                && Math.min(panel.width / (WIDTH + BESIDE_WIDTH), panel.height / CLOSED_HEIGHT)
                        > Math.min(panel.width / WIDTH, panel.height / height());
    }

    private double width(Dimension panel) {
        return isBeside(panel) ? WIDTH + BESIDE_WIDTH : WIDTH;
    }

    private double height(Dimension panel) {
        return isBeside(panel) ? CLOSED_HEIGHT : height();
    }

    /**
     * The size that shows the drawing at this scale; wide if a fold below the keys would make it clearly smaller.
     */
    Dimension sized(double scale, int mostHeight) {
        boolean isWide = fold != HandsetFold.NONE && height() * scale * LEAST_SHRINKING > mostHeight;
        return new Dimension((int) Math.round((isWide ? WIDTH + BESIDE_WIDTH : WIDTH) * scale), (int)
                Math.round((isWide ? CLOSED_HEIGHT : height()) * scale));
    }

    /** The whole drawing. */
    Rectangle2D whole(Component parent) {
        return new Rectangle2D.Double(0, 0, width(parent.getSize()), height(parent.getSize()));
    }

    /** The background of the open fold. */
    Rectangle2D screen(Component parent) {
        return isBeside(parent.getSize())
                ? BESIDE
                : new Rectangle2D.Double(20, FOLD_TOP, 280, fold.heightUnits() - FOLD_BELOW);
    }

    private Rectangle2D place(Component child, Dimension panel) {
        Rectangle2D place = places.get(child);
        if (isBeside(panel)) {
            return place == SCOPE ? SCOPE_BESIDE : place == EVENTS ? EVENTS_BESIDE : place;
        }
        return place;
    }

    static double heightOf(PhoneKey key) {
        return placeOf(key).getHeight();
    }

    static Rectangle2D placeOf(PhoneKey key) {
        return switch (key) {
            case SOFT_LEFT -> new Rectangle2D.Double(20, SOFT_TOP, SIDE_WIDTH, SOFT_HEIGHT);
            case SOFT_RIGHT -> new Rectangle2D.Double(220, SOFT_TOP, SIDE_WIDTH, SOFT_HEIGHT);
            case CALL -> new Rectangle2D.Double(20, CALL_TOP, SIDE_WIDTH, CALL_HEIGHT);
            case END -> new Rectangle2D.Double(220, CALL_TOP, SIDE_WIDTH, CALL_HEIGHT);
            case MESSAGE -> new Rectangle2D.Double(20, LOWER_TOP, SIDE_WIDTH, LOWER_HEIGHT);
            case MENU -> new Rectangle2D.Double(220, LOWER_TOP, HALF_WIDTH, LOWER_HEIGHT);
            case CLEAR -> new Rectangle2D.Double(300 - HALF_WIDTH, LOWER_TOP, HALF_WIDTH, LOWER_HEIGHT);
            case UP -> new Rectangle2D.Double(140, PAD_TOP + 2, 40, 29);
            case DOWN -> new Rectangle2D.Double(140, PAD_TOP + 65, 40, 29);
            case LEFT -> new Rectangle2D.Double(114, PAD_TOP + 33, 26, 30);
            case RIGHT -> new Rectangle2D.Double(180, PAD_TOP + 33, 26, 30);
            case OK -> new Rectangle2D.Double(141, PAD_TOP + 33, 38, 30);
            default -> digitPlace(key);
        };
    }

    private static Rectangle2D digitPlace(PhoneKey key) {
        int index = key.ordinal();
        return new Rectangle2D.Double(
                20 + index % 3 * (KEY_WIDTH + KEY_GAP),
                KEY_TOP + index / 3 * (KEY_HEIGHT + ROW_GAP),
                KEY_WIDTH,
                KEY_HEIGHT);
    }

    /** Pixels per unit. */
    double scale(Component parent) {
        Dimension panel = parent.getSize();
        return Math.min(panel.width / width(panel), panel.height / height(panel));
    }

    /** Converts a rectangle of the drawing to pixels on the panel. */
    Rectangle2D onPanel(Component parent, Rectangle2D place) {
        double scale = scale(parent);
        double left = (parent.getWidth() - width(parent.getSize()) * scale) / 2;
        double top = (parent.getHeight() - height(parent.getSize()) * scale) / 2;
        return new Rectangle2D.Double(
                left + place.getX() * scale,
                top + place.getY() * scale,
                place.getWidth() * scale,
                place.getHeight() * scale);
    }

    @Override
    public void layoutContainer(Container parent) {
        for (Component child : parent.getComponents()) {
            Rectangle2D box = onPanel(parent, place(child, parent.getSize()));
            int x = (int) Math.round(box.getX());
            int y = (int) Math.round(box.getY());
            child.setBounds(x, y, (int) Math.round(box.getMaxX()) - x, (int) Math.round(box.getMaxY()) - y);
        }
    }

    /** Sets the rectangle of a child on the drawing. */
    void place(Component child, Rectangle2D place) {
        places.put(child, place);
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return new Dimension(Theme.px(WIDTH), Theme.px(height()));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension((int) (WIDTH / 2), (int) (height() / 2));
    }
}
