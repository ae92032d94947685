package simrobot.ui.editor;

import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;
import simrobot.editor.Draft;
import simrobot.editor.Edits;
import simrobot.editor.Handle;
import simrobot.editor.Item;
import simrobot.editor.Picking;
import simrobot.ui.PoseTexts;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * The mouse on the floor of the editor: with the arrow it selects, moves, and pulls handles; with the other tools it draws from
 * where it is pressed to where it is let go. Shift keeps walls straight. The wheel zooms; the right button pans.
 */
final class EditorMouse extends MouseAdapter {
    private static final double ZOOM_PER_NOTCH = 1.15;
    private static final double LEAST_METERS = 0.005;

    private enum Drag {
        NONE,
        PAN,
        DRAW,
        MOVE,
        PULL
    }

    private final EditorView floor;
    private Drag drag = Drag.NONE;
    private Position from;
    private Handle handle;
    private double lastX;
    private double lastY;

    EditorMouse(EditorView floor) {
        this.floor = floor;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        floor.requestFocusInWindow();
        lastX = event.getX();
        lastY = event.getY();
        if (!SwingUtilities.isLeftMouseButton(event)) {
            drag = Drag.PAN;
        } else if (floor.tool() == EditorTool.SELECT) {
            grasp(event);
        } else {
            drag = Drag.DRAW;
            from = snapped(event);
        }
    }

    private void grasp(MouseEvent event) {
        Draft draft = floor.draft();
        double x = worldX(event);
        double y = worldY(event);
        Optional<Handle> grasped =
                draft.selected().flatMap(item -> Picking.handleAt(draft.world(), item, x, y, floor.reach()));
        Optional<Item> hit = Picking.itemAt(draft.world(), x, y, floor.reach());
        if (grasped.isPresent()) {
            handle = grasped.get();
            drag = Drag.PULL;
        } else if (hit.isPresent()) {
            draft.select(hit.get());
            from = new Position(x, y);
            drag = Drag.MOVE;
        } else {
            draft.select(null);
            drag = Drag.PAN;
        }
        floor.tell();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        switch (drag) {
            case PAN -> floor.look(floor.viewport().draggedBy(event.getX() - lastX, event.getY() - lastY));
            case DRAW -> draw(event);
            case MOVE -> move(event);
            case PULL -> pull(event);
            case NONE -> {
                // a drag that began elsewhere
            }
        }
        lastX = event.getX();
        lastY = event.getY();
    }

    private void draw(MouseEvent event) {
        Position to = end(event, from);
        World before = floor.draft().settled();
        boolean something = Math.hypot(to.xMeters() - from.xMeters(), to.yMeters() - from.yMeters()) > LEAST_METERS;
        if (something || floor.tool() == EditorTool.HOME) {
            floor.draft()
                    .attempt(EditorItems.made(
                            before, floor.tool(), from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters()));
        } else {
            floor.draft().forget();
        }
        floor.point(to, measure(from, to));
    }

    private Position end(MouseEvent event, Position begin) {
        boolean straight = event.isShiftDown() && floor.tool() != EditorTool.BOX;
        if (floor.tool() == EditorTool.HOME) {
            return new Position(worldX(event), worldY(event));
        }
        return straight ? floor.snap().straight(begin, worldX(event), worldY(event)) : snapped(event);
    }

    private void move(MouseEvent event) {
        double dx = floor.snap().of(worldX(event) - from.xMeters());
        double dy = floor.snap().of(worldY(event) - from.yMeters());
        Draft draft = floor.draft();
        draft.selected().ifPresent(item -> draft.attempt(Edits.moved(draft.settled(), item, dx, dy)));
        floor.point(new Position(worldX(event), worldY(event)), reading(dx, dy));
    }

    private void pull(MouseEvent event) {
        Draft draft = floor.draft();
        Item item = handle.item();
        Position to;
        if (item.kind() == Item.Kind.HOME) {
            to = new Position(worldX(event), worldY(event));
        } else if (item.kind() == Item.Kind.WALL) {
            Handle other = Edits.handles(draft.settled(), item).get(1 - handle.number());
            Position fixed = new Position(other.xMeters(), other.yMeters());
            to = event.isShiftDown()
                    ? floor.snap().straight(fixed, worldX(event), worldY(event))
                    : floor.snap().of(without(item), worldX(event), worldY(event), floor.reach());
            floor.point(to, measure(fixed, to));
        } else {
            to = snapped(event);
            floor.point(to, reading(to.xMeters(), to.yMeters()));
        }
        draft.attempt(Edits.pulled(draft.settled(), handle, to.xMeters(), to.yMeters()));
        floor.repaint();
    }

    /** A wall's end is not to stick to where it was. */
    private World without(Item item) {
        return Edits.without(floor.draft().settled(), item);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        Draft draft = floor.draft();
        if (drag == Drag.DRAW && floor.tool() == EditorTool.HOME) {
            draw(event);
        }
        if (drag == Drag.DRAW && draft.world() != draft.settled()) {
            draft.settle();
            draft.select(Edits.last(draft.world(), floor.tool().kind()));
        } else if (drag == Drag.MOVE || drag == Drag.PULL) {
            draft.settle();
        }
        drag = Drag.NONE;
        floor.tell();
    }

    /** Whatever is being dragged stays as it was. */
    boolean cancel() {
        boolean dragging = drag != Drag.NONE;
        drag = Drag.NONE;
        floor.draft().forget();
        return dragging;
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        Position at = floor.tool() == EditorTool.SELECT ? new Position(worldX(event), worldY(event)) : snapped(event);
        floor.point(at, floor.tool() == EditorTool.SELECT ? "" : reading(at.xMeters(), at.yMeters()));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        floor.point(null, "");
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double factor = Math.pow(ZOOM_PER_NOTCH, -event.getPreciseWheelRotation());
        floor.look(floor.viewport().zoomedAt(event.getX(), event.getY(), factor));
    }

    private Position snapped(MouseEvent event) {
        return floor.snap().of(floor.draft().settled(), worldX(event), worldY(event), floor.reach());
    }

    private static String reading(double x, double y) {
        return PoseTexts.fixed(x, 2) + "  " + PoseTexts.fixed(y, 2) + " m";
    }

    private static String measure(Position from, Position to) {
        double dx = to.xMeters() - from.xMeters();
        double dy = to.yMeters() - from.yMeters();
        return PoseTexts.fixed(Math.hypot(dx, dy), 2) + " m  " + PoseTexts.degrees(Math.atan2(dy, dx)) + "\u00b0";
    }

    private double worldX(MouseEvent event) {
        return floor.viewport().worldX(event.getX());
    }

    private double worldY(MouseEvent event) {
        return floor.viewport().worldY(event.getY());
    }

    FocusListener repaintOnFocus() {
        return new FocusListener() {
            @Override
            public void focusGained(FocusEvent event) {
                floor.repaint();
            }

            @Override
            public void focusLost(FocusEvent event) {
                floor.repaint();
            }
        };
    }
}
