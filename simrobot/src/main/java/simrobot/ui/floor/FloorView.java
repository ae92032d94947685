package simrobot.ui.floor;

import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.Viewport;
import simrobot.world.Area;

/** A part of a floor. The wheel zooms at the pointer, plus and minus at the centre; Home fits the whole floor into the view. */
public abstract class FloorView extends PaintedComponent {
    private static final double ZOOM_PER_NOTCH = 1.15;
    private static final double PAN_UNITS = 48;

    private final String actions;
    private final double marginUnits;
    private Viewport viewport = new Viewport(0, 0, 40, 1, 1);
    private Choice choice = Choice.START;

    /** The rule that determines the visible part. */
    private enum Choice {
        START,
        WHOLE,
        USER
    }

    /**
     * @param name of the component
     * @param actions prefix of the names of its actions
     * @param marginUnits around a fitted floor
     */
    protected FloorView(String name, String actions, double marginUnits) {
        super(AccessibleRole.CANVAS);
        this.actions = actions;
        this.marginUnits = marginUnits;
        setName(name);
        setOpaque(true);
        makeFocusable();
        bind("in", () -> zoom(1.25), 0, KeyEvent.VK_PLUS, KeyEvent.VK_ADD, KeyEvent.VK_EQUALS);
        bind("out", () -> zoom(0.8), 0, KeyEvent.VK_MINUS, KeyEvent.VK_SUBTRACT);
        bind("fit", this::fit, 0, KeyEvent.VK_HOME);
        addMouseWheelListener(event -> look(viewport.zoomedAt(
                event.getX(), event.getY(), Math.pow(ZOOM_PER_NOTCH, -event.getPreciseWheelRotation()))));
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                viewport = viewport.sized(getWidth(), getHeight());
                if (choice == Choice.START) {
                    showStart();
                } else if (choice == Choice.WHOLE) {
                    fit();
                }
            }
        });
    }

    /** The area shown by {@link #fit}. */
    protected abstract Area floorArea();

    /** Binds keys while the view has the focus. @param modifiers of InputEvent */
    protected final UserAction bind(String id, Runnable act, int modifiers, int... keys) {
        UserAction action = new UserAction(actions + "." + id, "", act);
        for (int key : keys) {
            action.bind(this, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(key, modifiers));
        }
        return action;
    }

    /** An action of the four arrow keys, dx and dy in steps to the right and up. */
    protected interface ArrowAction {
        void go(int dx, int dy);
    }

    /** Binds the arrow keys while the view has the focus. @param modifiers of InputEvent */
    protected final void bindArrows(String id, ArrowAction act, int modifiers) {
        bind(id + "." + KeyEvent.VK_LEFT, () -> act.go(-1, 0), modifiers, KeyEvent.VK_LEFT);
        bind(id + "." + KeyEvent.VK_RIGHT, () -> act.go(1, 0), modifiers, KeyEvent.VK_RIGHT);
        bind(id + "." + KeyEvent.VK_UP, () -> act.go(0, 1), modifiers, KeyEvent.VK_UP);
        bind(id + "." + KeyEvent.VK_DOWN, () -> act.go(0, -1), modifiers, KeyEvent.VK_DOWN);
    }

    public final Viewport viewport() {
        return viewport;
    }

    /** Shows another part; afterwards the view no longer fits itself. */
    public final void look(Viewport newViewport) {
        viewport = newViewport;
        choice = Choice.USER;
        repaint();
    }

    /** Shows the whole floor, also after a change of the view's size. */
    public final void fit() {
        choice = Choice.WHOLE;
        viewport = whole();
        repaint();
    }

    private Viewport whole() {
        return Viewport.fitting(floorArea(), getWidth(), getHeight(), Theme.exact(marginUnits));
    }

    /** Shows the initial part, also after a change of the view's size. */
    protected final void showStart() {
        choice = Choice.START;
        viewport = start(whole());
        repaint();
    }

    /** True if the user has not chosen a part yet. */
    protected final boolean isAtStart() {
        return choice == Choice.START;
    }

    /**
     * The initial part.
     *
     * @param whole the whole floor
     */
    protected Viewport start(Viewport whole) {
        return whole;
    }

    public final void zoom(double factor) {
        look(viewport.zoomedAt(getWidth() / 2.0, getHeight() / 2.0, factor));
    }

    /** Moves the view by steps of 48 units. */
    protected final void pan(int dx, int dy) {
        look(viewport.draggedBy(-dx * Theme.exact(PAN_UNITS), dy * Theme.exact(PAN_UNITS)));
    }

    public final double worldX(MouseEvent event) {
        return viewport.worldX(event.getX());
    }

    public final double worldY(MouseEvent event) {
        return viewport.worldY(event.getY());
    }

    /** Converts a distance in units to metres on the floor. */
    public final double meters(double units) {
        return Theme.exact(units) / viewport.pixelsPerMeter();
    }

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet() ? super.getPreferredSize() : new Dimension(Theme.px(720), Theme.px(460));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(200), Theme.px(160));
    }
}
