package simgsm.ui.pane;

import java.awt.Component;
import java.awt.Container;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.KeyboardFocusManager;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.Stream;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.accessibility.AccessibleValue;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * The gap between two parts of a window, which sets the size of the part at its right, or below it. The mouse drags
 * it; the arrow keys move it by 16 units, with Shift by 1; Home and End move it to its limits; Enter and a double
 * click restore the part's own size. F8 moves the focus to the window's next divider, Escape back to where it was
 * before.
 *
 * <p>The container's layout gets the part's size from {@link #sized} and sets the divider's place by {@link #place}.
 */
public final class Divider extends JComponent implements Accessible {
    private static final int STEP_UNITS = 16;

    private final int leastUnits;
    private boolean upright;
    private OptionalInt wantedUnits = OptionalInt.empty();
    private int pixels;
    private int mostPixels;
    /** Pressed position, and the part's size then. */
    private int grasped;

    private int graspedPixels;
    /** Component focused before F8. */
    private transient Component before;

    /**
     * A divider with the part's own size.
     *
     * @param id its name for tests; @param name as "Divider between floor and modem"
     * @param leastUnits of the part
     */
    public Divider(String id, String name, Locale language, int leastUnits) {
        this.leastUnits = leastUnits;
        ComponentNames.name(this, id, name);
        setToolTipText(name);
        setFocusable(true);
        PaintedComponent.repaintOnFocus(this);
        bind("left", KeyEvent.VK_LEFT, true, 1);
        bind("right", KeyEvent.VK_RIGHT, true, -1);
        bind("up", KeyEvent.VK_UP, false, 1);
        bind("down", KeyEvent.VK_DOWN, false, -1);
        bind("first", KeyEvent.VK_HOME, () -> want(mostPixels));
        bind("last", KeyEvent.VK_END, () -> want(0));
        bind("reset", KeyEvent.VK_ENTER, this::reset);
        bind("leave", KeyEvent.VK_ESCAPE, this::leave);
        new UserAction("divider.next", DesktopTexts.in(language).of("divider.next"), this::focusNext)
                .bindInWindow(this, KeyStroke.getKeyStroke(KeyEvent.VK_F8, 0));
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    private void bind(String id, int key, Runnable task) {
        new UserAction("divider." + id, "", task).bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
    }

    /** @param across true if the key moves a vertical divider; @param sign 1 if the key enlarges the part */
    private void bind(String id, int key, boolean across, int sign) {
        bind(id, key, () -> step(across, sign * STEP_UNITS));
        new UserAction("divider." + id + ".little", "", () -> step(across, sign))
                .bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, InputEvent.SHIFT_DOWN_MASK));
    }

    /** Adds in units: a single one may be less than a pixel and would be lost by rounding. */
    private void step(boolean across, int changeUnits) {
        if (across == upright) {
            int most = units(mostPixels);
            change(OptionalInt.of(Math.max(leastUnits, Math.min(most, nowUnits() + changeUnits))));
        }
    }

    private int nowUnits() {
        boolean isAsWanted = wantedUnits.isPresent() && Theme.px(wantedUnits.getAsInt()) == pixels;
        return isAsWanted ? wantedUnits.getAsInt() : units(pixels);
    }

    private static int units(int pixels) {
        return (int) Math.round(pixels / Theme.zoom());
    }

    // ---- for the layout --------------------------------------------------------------------------------------------

    /**
     * The size of the part in pixels: the user's choice, else its own.
     *
     * @param own without a choice; @param most available
     */
    public int sized(int own, int most) {
        mostPixels = Math.max(most, Theme.px(leastUnits));
        pixels = wantedUnits.isEmpty() ? own : limited(Theme.px(wantedUnits.getAsInt()));
        return pixels;
    }

    private int limited(int wanted) {
        return Math.max(Theme.px(leastUnits), Math.min(mostPixels, wanted));
    }

    /** Sets the bounds in the gap; vertical between two parts side by side. */
    public void place(int x, int y, int width, int height) {
        upright = height > width;
        setCursor(Cursor.getPredefinedCursor(upright ? Cursor.E_RESIZE_CURSOR : Cursor.N_RESIZE_CURSOR));
        setBounds(x, y, width, height);
    }

    // ---- moves -----------------------------------------------------------------------------------------------------

    private void want(int wantedPixels) {
        change(OptionalInt.of(units(limited(wantedPixels))));
    }

    /** Restores the part's own size. */
    public void reset() {
        change(OptionalInt.empty());
    }

    private void change(OptionalInt units) {
        if (units.equals(wantedUnits)) {
            return;
        }
        int now = pixels;
        wantedUnits = units;
        pixels = units.isEmpty() ? pixels : limited(Theme.px(units.getAsInt()));
        if (accessibleContext != null) {
            accessibleContext.firePropertyChange(AccessibleContext.ACCESSIBLE_VALUE_PROPERTY, now, pixels);
        }
        if (getParent() instanceof JComponent parts) {
            parts.revalidate();
        }
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            grasped = along(event);
            graspedPixels = pixels;
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            want(graspedPixels + grasped - along(event));
        }

        @Override
        public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
                reset();
            }
        }

        /** In the container's coordinates, since the divider moves. */
        private int along(MouseEvent event) {
            return upright ? getX() + event.getX() : getY() + event.getY();
        }
    }

    // ---- the focus -------------------------------------------------------------------------------------------------

    private void focusNext() {
        List<Divider> all = in(SwingUtilities.getRoot(this)).toList();
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        int at = all.indexOf(owner);
        Divider next = all.get((at + 1) % all.size());
        next.before = at >= 0 ? all.get(at).before : owner;
        next.requestFocusInWindow();
    }

    private static Stream<Divider> in(Component root) {
        if (root instanceof Divider divider) {
            return Stream.of(divider).filter(Component::isShowing);
        }
        return root instanceof Container container
                ? Stream.of(container.getComponents()).flatMap(Divider::in)
                : Stream.empty();
    }

    private void leave() {
        if (before != null) {
            before.requestFocusInWindow();
        } else {
            transferFocus();
        }
    }

    // ----------------------------------------------------------------------------------------------------------------

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            if (isFocusOwner()) {
                g.setColor(Theme.color(Ink.ACCENT));
                double thick = Math.min(Theme.exact(4), Math.min(getWidth(), getHeight()));
                g.fill(
                        upright
                                ? Drawing.round((getWidth() - thick) / 2, 0, thick, getHeight(), thick / 2)
                                : Drawing.round(0, (getHeight() - thick) / 2, getWidth(), thick, thick / 2));
            } else {
                Drawing.grip(g, getWidth(), getHeight());
            }
        } finally {
            g.dispose();
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleDivider();
        }
        return accessibleContext;
    }

    /** A separator with the part's size in units as its value. */
    private final class AccessibleDivider extends AccessibleJComponent implements AccessibleValue {
        @Override
        public AccessibleRole getAccessibleRole() {
            return AccessibleRole.SEPARATOR;
        }

        @Override
        public AccessibleValue getAccessibleValue() {
            return this;
        }

        @Override
        public Number getCurrentAccessibleValue() {
            return nowUnits();
        }

        @Override
        public boolean setCurrentAccessibleValue(Number units) {
            want(Theme.px(units.intValue()));
            return true;
        }

        @Override
        public Number getMinimumAccessibleValue() {
            return leastUnits;
        }

        @Override
        public Number getMaximumAccessibleValue() {
            return units(mostPixels);
        }
    }
}
