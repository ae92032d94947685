package simrobot.ui.editor;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import simrobot.drawing.NumberTexts;
import simrobot.editor.Draft;
import simrobot.editor.Edits;
import simrobot.editor.Handle;
import simrobot.editor.Item;
import simrobot.editor.Picking;
import simrobot.world.ItemKind;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * The mouse on the floor of the editor. The arrow tool selects, moves, and pulls handles; the other tools draw from the
 * press to the release. Shift keeps walls straight. The right button pans. A drag ends without effect if the draft
 * changes otherwise during it, such as by undo.
 */
final class EditorMouse extends MouseAdapter {
    private static final double LEAST_METERS = 0.005;

    private final EditorView view;
    /** The effect of a movement while a button is pressed; null for none. */
    private Consumer<MouseEvent> drag;
    /** The draft at the beginning of the drag. */
    private World before;

    private boolean draws;
    private double lastX;
    private double lastY;

    EditorMouse(EditorView view) {
        this.view = view;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        lastX = event.getX();
        lastY = event.getY();
        before = view.draft().committed();
        draws = SwingUtilities.isLeftMouseButton(event) && view.tool() != EditorTool.SELECT;
        if (draws) {
            Position from = snapped(event);
            drag = to -> draw(from, to);
        } else if (SwingUtilities.isLeftMouseButton(event)) {
            drag = grasp(event);
            view.fireChanged();
        } else {
            drag = this::pan;
        }
    }

    /**
     * Selects the item at the pointer.
     *
     * @return the effect of a drag
     */
    private Consumer<MouseEvent> grasp(MouseEvent event) {
        Draft draft = view.draft();
        Position from = at(event);
        Optional<Handle> handle = draft.selected()
                .flatMap(item -> Picking.handleAt(before, item, from.xMeters(), from.yMeters(), view.reach()));
        if (handle.isPresent()) {
            return to -> pull(handle.get(), to);
        }
        Optional<Item> hit = Picking.itemAt(before, from.xMeters(), from.yMeters(), view.reach());
        draft.select(hit.orElse(null));
        return hit.isEmpty() ? this::pan : to -> move(hit.get(), from, to);
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        endIfChanged();
        if (drag != null) {
            drag.accept(event);
        }
        lastX = event.getX();
        lastY = event.getY();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        endIfChanged();
        if (drag == null) {
            return;
        }
        Draft draft = view.draft();
        if (draws && view.tool().draws(ItemKind.Shape.PLACE)) {
            drag.accept(event);
        }
        drag = null;
        boolean made = draws && draft.world() != draft.committed();
        draft.commit();
        if (made) {
            draft.select(Edits.last(draft.world(), view.tool().kind()));
        }
        view.fireChanged();
    }

    private void endIfChanged() {
        if (view.draft().committed() != before) {
            cancel();
        }
    }

    /**
     * Ends a drag without effect.
     *
     * @return true if there was one
     */
    boolean cancel() {
        boolean dragging = drag != null;
        drag = null;
        view.draft().discard();
        return dragging;
    }

    // ---- drags -----------------------------------------------------------------------------------------------------

    private void pan(MouseEvent event) {
        view.look(view.viewport().draggedBy(event.getX() - lastX, event.getY() - lastY));
    }

    private void draw(Position from, MouseEvent event) {
        EditorTool tool = view.tool();
        boolean isPlace = tool.draws(ItemKind.Shape.PLACE);
        Position to = isPlace
                ? at(event)
                : event.isShiftDown() && tool.draws(ItemKind.Shape.LINE) ? straight(from, event) : snapped(event);
        if (isPlace || distance(from, to) > LEAST_METERS) {
            view.draft().preview(Edits.with(before, tool.kind().drawn(before, from, to)));
        } else {
            view.draft().discard();
        }
        view.point(to, measure(from, to));
    }

    private void move(Item item, Position from, MouseEvent event) {
        double dx = view.snap().of(view.worldX(event) - from.xMeters());
        double dy = view.snap().of(view.worldY(event) - from.yMeters());
        view.draft().preview(Edits.moved(before, item, dx, dy));
        view.point(at(event), reading(dx, dy));
    }

    private void pull(Handle handle, MouseEvent event) {
        Item item = handle.item();
        Position to = at(event);
        if (item.kind().shape() == ItemKind.Shape.LINE) {
            Position fixed =
                    Edits.handles(before, item).get(1 - handle.number()).place();
            // without the wall itself, so that its end does not snap to its old place
            to = event.isShiftDown() ? straight(fixed, event) : snapped(event, Edits.without(before, item));
            view.point(to, measure(fixed, to));
        } else if (item.kind().shape() == ItemKind.Shape.AREA) {
            to = snapped(event);
            view.point(to, reading(to.xMeters(), to.yMeters()));
        }
        view.draft().preview(Edits.pulled(before, handle, to.xMeters(), to.yMeters()));
        view.repaint();
    }

    // ---- without a button ------------------------------------------------------------------------------------------

    @Override
    public void mouseMoved(MouseEvent event) {
        boolean selects = view.tool() == EditorTool.SELECT;
        Position at = selects ? at(event) : snapped(event);
        view.point(at, selects ? "" : reading(at.xMeters(), at.yMeters()));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        view.point(null, "");
    }

    // ---- places ----------------------------------------------------------------------------------------------------

    private Position at(MouseEvent event) {
        return new Position(view.worldX(event), view.worldY(event));
    }

    private Position straight(Position from, MouseEvent event) {
        return view.snap().straight(from, view.worldX(event), view.worldY(event));
    }

    private Position snapped(MouseEvent event) {
        return snapped(event, view.draft().committed());
    }

    private Position snapped(MouseEvent event, World world) {
        return view.snap().of(world, view.worldX(event), view.worldY(event), view.reach());
    }

    private static double distance(Position from, Position to) {
        return Math.hypot(to.xMeters() - from.xMeters(), to.yMeters() - from.yMeters());
    }

    private static String reading(double x, double y) {
        return NumberTexts.fixed(x, 2) + "  " + NumberTexts.fixed(y, 2) + " m";
    }

    private static String measure(Position from, Position to) {
        double direction = Math.atan2(to.yMeters() - from.yMeters(), to.xMeters() - from.xMeters());
        return NumberTexts.fixed(distance(from, to), 2) + " m  " + NumberTexts.degrees(direction) + "\u00b0";
    }
}
