package simrobot.ui.floor;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.RobotPainter;
import simrobot.drawing.Ruler;
import simrobot.editor.Snap;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.world.Position;

/**
 * The mouse on the floor. Dragging a robot moves it; dragging its handle, or the robot with Shift or the right button,
 * turns it; dragging the floor pans; a double click on the floor fits the world. While a place is being chosen,
 * pressing on the floor sets it and dragging from there sets the heading. With the ruler, dragging measures.
 */
final class WorldMouse extends MouseAdapter {
    private static final double PLACES_PER_METER = 20;
    private static final Snap TO_THE_MILLIMETRE = new Snap(0);

    private final WorldView view;
    /** The effect of a movement while a button is pressed; null for none. */
    private Consumer<MouseEvent> drag;

    private double lastX;
    private double lastY;

    WorldMouse(WorldView view) {
        this.view = view;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        lastX = event.getX();
        lastY = event.getY();
        Optional<RobotSnapshot> hit = robotAt(event);
        boolean left = SwingUtilities.isLeftMouseButton(event);
        if (view.ruler() != null && left) {
            beginMeasuring(event);
        } else if (view.isLive() && isOnHandle(event)) {
            view.selectedRobot().ifPresent(view.placing()::beginDrag);
            drag = this::turn;
        } else if (hit.isPresent()) {
            view.requestSelection(hit.get().name());
            drag = view.isLive() ? dragOf(hit.get(), event, left && !event.isShiftDown()) : null;
        } else if (view.placeListener().isPresent() && left) {
            beginChoosing(event);
        } else {
            drag = this::pan;
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (drag != null) {
            drag.accept(event);
        }
        lastX = event.getX();
        lastY = event.getY();
        mouseMoved(event);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        drag = null;
        view.placing().endDrag();
    }

    private void pan(MouseEvent event) {
        view.setFollowing(false);
        view.look(view.viewport().draggedBy(event.getX() - lastX, event.getY() - lastY));
    }

    // ---- robots ----------------------------------------------------------------------------------------------------

    private Consumer<MouseEvent> dragOf(RobotSnapshot robot, MouseEvent event, boolean moves) {
        view.placing().beginDrag(robot);
        double gripX = robot.xMeters() - view.worldX(event);
        double gripY = robot.yMeters() - view.worldY(event);
        return moves ? to -> move(to, gripX, gripY) : this::turn;
    }

    private void move(MouseEvent event, double gripX, double gripY) {
        dragged()
                .ifPresent(robot -> view.placing()
                        .put(robot, view.worldX(event) + gripX, view.worldY(event) + gripY, robot.headingRadians()));
    }

    private void turn(MouseEvent event) {
        dragged().ifPresent(robot -> {
            double heading = heading(event, robot.xMeters(), robot.yMeters());
            view.placing().put(robot, robot.xMeters(), robot.yMeters(), heading);
        });
    }

    /** The robot at the beginning of the drag; empty if it has been removed since. */
    private Optional<RobotSnapshot> dragged() {
        return view.selectedRobot().filter(view.placing()::isDragging);
    }

    /** The heading towards the pointer, in whole degrees, in steps of 15 with Shift. */
    private double heading(MouseEvent event, double x, double y) {
        double towards = Math.atan2(view.worldY(event) - y, view.worldX(event) - x);
        double step = event.isShiftDown() ? 15 : 1;
        return Math.toRadians(Math.rint(Math.toDegrees(towards) / step) * step);
    }

    private void beginChoosing(MouseEvent event) {
        double x = Math.rint(view.worldX(event) * PLACES_PER_METER) / PLACES_PER_METER;
        double y = Math.rint(view.worldY(event) * PLACES_PER_METER) / PLACES_PER_METER;
        view.placeListener().ifPresent(listener -> listener.at(x, y, Double.NaN));
        drag = to -> view.placeListener().ifPresent(listener -> listener.at(x, y, heading(to, x, y)));
    }

    private Optional<RobotSnapshot> robotAt(MouseEvent event) {
        return view.scene().robots().stream()
                .filter(robot -> isWithin(
                        event, robot.xMeters(), robot.yMeters(), Math.max(Pioneer2Dx.RADIUS_METERS, view.meters(8))))
                .findFirst();
    }

    private boolean isOnHandle(MouseEvent event) {
        return view.selectedRobot()
                .filter(robot -> {
                    double x = robot.xMeters() + RobotPainter.HANDLE_METERS * Math.cos(robot.headingRadians());
                    double y = robot.yMeters() + RobotPainter.HANDLE_METERS * Math.sin(robot.headingRadians());
                    return isWithin(event, x, y, Math.max(0.06, view.meters(8)));
                })
                .isPresent();
    }

    private boolean isWithin(MouseEvent event, double x, double y, double meters) {
        return Math.hypot(x - view.worldX(event), y - view.worldY(event)) <= meters;
    }

    // ---- ruler -----------------------------------------------------------------------------------------------------

    /** Drags the nearer end within 9 units; elsewhere begins a new measurement. */
    private void beginMeasuring(MouseEvent event) {
        Ruler ruler = view.ruler();
        if (isNear(event, ruler.from())) {
            drag = to -> measure(new Ruler(snapped(to), ruler.to()));
        } else {
            Position fixed = isNear(event, ruler.to()) ? ruler.from() : snapped(event);
            if (fixed != ruler.from()) {
                measure(new Ruler(fixed, fixed));
            }
            drag = to -> measure(new Ruler(fixed, snapped(to)));
        }
    }

    /** Updates the ruler, unless it was hidden during the drag. */
    private void measure(Ruler ruler) {
        if (view.ruler() == null) {
            drag = null;
        } else {
            view.measure(ruler);
        }
    }

    private boolean isNear(MouseEvent event, Position place) {
        return isWithin(event, place.xMeters(), place.yMeters(), view.meters(9));
    }

    /** A robot's centre within 9 units or a wall's end within 7, else the position to the millimetre. */
    private Position snapped(MouseEvent event) {
        for (RobotSnapshot robot : view.scene().robots()) {
            Position middle = new Position(robot.xMeters(), robot.yMeters());
            if (isNear(event, middle)) {
                return middle;
            }
        }
        return TO_THE_MILLIMETRE.of(view.scene().world(), view.worldX(event), view.worldY(event), view.meters(7));
    }

    // ---- without a button ------------------------------------------------------------------------------------------

    @Override
    public void mouseClicked(MouseEvent event) {
        if (event.getClickCount() == 2 && robotAt(event).isEmpty()) {
            view.setFollowing(false);
            view.fit();
        }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        view.setReadout(
                NumberTexts.fixed(view.worldX(event), 2) + "  " + NumberTexts.fixed(view.worldY(event), 2) + " m");
    }

    @Override
    public void mouseExited(MouseEvent event) {
        view.setReadout("");
    }
}
