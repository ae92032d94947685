package simrobot.ui.floor;

import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;
import simgsm.ui.Theme;
import simrobot.editor.Snap;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.PoseTexts;
import simrobot.world.Position;

/**
 * The mouse on the floor: wheel zooms at the pointer; dragging a robot moves it, dragging its handle (or the robot with Shift
 * or the right button) turns it, dragging the floor pans; a double click on the floor fits the world. While a place is asked
 * for, pressing on the floor names it and dragging from there turns the newcomer. While the ruler lies there, dragging measures.
 */
final class WorldMouse extends MouseAdapter {
    private static final double ZOOM_PER_NOTCH = 1.15;
    private static final Snap TO_THE_MILLIMETRE = new Snap(0);

    private enum Drag {
        NONE,
        PAN,
        MOVE,
        TURN,
        AIM,
        MEASURE
    }

    private final WorldView view;
    private Drag drag = Drag.NONE;
    private double lastX;
    private double lastY;
    private double gripX;
    private double gripY;
    private double aimX;
    private double aimY;
    private boolean rulerBegin;
    private Position rulerFixed;

    WorldMouse(WorldView view) {
        this.view = view;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        view.requestFocusInWindow();
        lastX = event.getX();
        lastY = event.getY();
        Optional<RobotSnapshot> hit = robotAt(event);
        if (view.ruler() != null && SwingUtilities.isLeftMouseButton(event)) {
            drag = Drag.MEASURE;
            takeRuler(event);
        } else if (view.isLive() && isOnHandle(event)) {
            drag = Drag.TURN;
        } else if (hit.isPresent()) {
            RobotSnapshot robot = hit.get();
            view.pick(robot);
            if (!view.isLive()) {
                drag = Drag.NONE;
                return;
            }
            drag = SwingUtilities.isLeftMouseButton(event) && !event.isShiftDown() ? Drag.MOVE : Drag.TURN;
            view.hand().take(robot);
            gripX = robot.xMeters() - worldX(event);
            gripY = robot.yMeters() - worldY(event);
        } else if (view.isAskingForPlace() && SwingUtilities.isLeftMouseButton(event)) {
            drag = Drag.AIM;
            aimX = view.snapped(worldX(event));
            aimY = view.snapped(worldY(event));
            view.namePlace(aimX, aimY, Double.NaN);
        } else {
            drag = Drag.PAN;
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        switch (drag) {
            case PAN -> pan(event);
            case MOVE -> move(event);
            case TURN -> turn(event);
            case MEASURE ->
                view.measure(rulerBegin ? new Ruler(near(event), rulerFixed) : new Ruler(rulerFixed, near(event)));
            case AIM -> view.namePlace(aimX, aimY, towards(event, aimX, aimY));
            case NONE -> {
                // a drag that began elsewhere
            }
        }
        lastX = event.getX();
        lastY = event.getY();
        mouseMoved(event);
    }

    /** An end that is near is taken; anywhere else a new measurement begins. */
    private void takeRuler(MouseEvent event) {
        Ruler ruler = view.ruler();
        rulerBegin = isNear(event, ruler.from());
        if (rulerBegin) {
            rulerFixed = ruler.to();
        } else if (isNear(event, ruler.to())) {
            rulerFixed = ruler.from();
        } else {
            rulerFixed = near(event);
            view.measure(new Ruler(rulerFixed, rulerFixed));
        }
    }

    private boolean isNear(MouseEvent event, Position place) {
        double dx = view.viewport().screenX(place.xMeters()) - event.getX();
        double dy = view.viewport().screenY(place.yMeters()) - event.getY();
        return Math.hypot(dx, dy) <= Theme.exact(9);
    }

    /** The end of a wall or a robot's middle if one is meant, else the very place. */
    private Position near(MouseEvent event) {
        for (RobotSnapshot robot : view.picture().robots()) {
            Position middle = new Position(robot.xMeters(), robot.yMeters());
            if (isNear(event, middle)) {
                return middle;
            }
        }
        double reach = Theme.exact(7) / view.viewport().pixelsPerMeter();
        return TO_THE_MILLIMETRE.of(view.picture().world(), worldX(event), worldY(event), reach);
    }

    private void pan(MouseEvent event) {
        view.setFollowing(false);
        view.look(view.viewport().draggedBy(event.getX() - lastX, event.getY() - lastY));
    }

    private void move(MouseEvent event) {
        view.selectedRobot()
                .ifPresent(robot ->
                        view.hand().put(robot, worldX(event) + gripX, worldY(event) + gripY, robot.headingRadians()));
    }

    private void turn(MouseEvent event) {
        view.selectedRobot()
                .ifPresent(robot -> view.hand()
                        .put(
                                robot,
                                robot.xMeters(),
                                robot.yMeters(),
                                towards(event, robot.xMeters(), robot.yMeters())));
    }

    /** Towards the pointer, in whole degrees, in steps of 15 with Shift held. */
    private double towards(MouseEvent event, double x, double y) {
        double towards = Math.atan2(worldY(event) - y, worldX(event) - x);
        double step = event.isShiftDown() ? 15 : 1;
        return Math.toRadians(Math.rint(Math.toDegrees(towards) / step) * step);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        drag = Drag.NONE;
        view.hand().letGo();
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (event.getClickCount() == 2 && robotAt(event).isEmpty()) {
            view.setFollowing(false);
            view.fit();
        }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        view.setReadout(PoseTexts.fixed(worldX(event), 2) + "  " + PoseTexts.fixed(worldY(event), 2) + " m");
    }

    @Override
    public void mouseExited(MouseEvent event) {
        view.setReadout("");
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double factor = Math.pow(ZOOM_PER_NOTCH, -event.getPreciseWheelRotation());
        view.look(view.viewport().zoomedAt(event.getX(), event.getY(), factor));
    }

    private Optional<RobotSnapshot> robotAt(MouseEvent event) {
        double reach = Math.max(
                Pioneer2Dx.RADIUS_METERS, Theme.exact(8) / view.viewport().pixelsPerMeter());
        return view.picture().robots().stream()
                .filter(robot -> Math.hypot(robot.xMeters() - worldX(event), robot.yMeters() - worldY(event)) <= reach)
                .findFirst();
    }

    private boolean isOnHandle(MouseEvent event) {
        double reach = Math.max(0.06, Theme.exact(8) / view.viewport().pixelsPerMeter());
        return view.selectedRobot()
                .filter(robot -> {
                    double x = robot.xMeters() + RobotPainter.HANDLE_METERS * Math.cos(robot.headingRadians());
                    double y = robot.yMeters() + RobotPainter.HANDLE_METERS * Math.sin(robot.headingRadians());
                    return Math.hypot(x - worldX(event), y - worldY(event)) <= reach;
                })
                .isPresent();
    }

    private double worldX(MouseEvent event) {
        return view.viewport().worldX(event.getX());
    }

    private double worldY(MouseEvent event) {
        return view.viewport().worldY(event.getY());
    }

    /** The focus ring comes and goes. */
    FocusListener repaintOnFocus() {
        return new FocusListener() {
            @Override
            public void focusGained(FocusEvent event) {
                view.repaint();
            }

            @Override
            public void focusLost(FocusEvent event) {
                view.repaint();
            }
        };
    }
}
