package simrobot.ui.floor;

import java.util.Optional;
import javax.swing.Timer;
import simgsm.console.TextBundle;
import simrobot.drawing.RobotPreview;
import simrobot.robot.Placement;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.EventThread;
import simrobot.ui.OperatorActions;

/**
 * Moves robots for the window. A refused place is shown as a preview with the reason for 2.5 s; a robot dropped there
 * returns to the start of its drag.
 */
public final class RobotPlacing {
    private static final int PREVIEW_MILLIS = 2500;

    private final OperatorActions operator;
    private final TextBundle texts;
    private final Runnable changed;
    private final Timer fading = new Timer(PREVIEW_MILLIS, event -> show(null));
    private RobotPreview preview;
    private RobotSnapshot dragged;

    /** @param changed run when {@link #preview} changes */
    RobotPlacing(OperatorActions operator, TextBundle texts, Runnable changed) {
        this.operator = operator;
        this.texts = texts;
        this.changed = changed;
        fading.setRepeats(false);
    }

    public Optional<RobotPreview> preview() {
        return Optional.ofNullable(preview);
    }

    /** True while a robot is dragged or turned with the mouse. */
    public boolean isDragging() {
        return dragged != null;
    }

    /** True if this robot is being dragged. */
    boolean isDragging(RobotSnapshot robot) {
        return dragged != null && dragged.name().equals(robot.name());
    }

    void beginDrag(RobotSnapshot robot) {
        dragged = robot;
    }

    void put(RobotSnapshot robot, double x, double y, double heading) {
        operator.place(
                robot.name(), x, y, heading, EventThread.onEventThread(answer -> answered(x, y, heading, answer)));
    }

    private void answered(double x, double y, double heading, Placement answer) {
        boolean done = answer == Placement.DONE;
        show(done ? null : new RobotPreview(x, y, heading, reason(answer), true));
        fading.stop();
        if (!done && dragged == null) {
            fading.start();
        }
    }

    /** Ends a drag; a refused robot returns to its start. */
    void endDrag() {
        RobotSnapshot from = dragged;
        dragged = null;
        if (from != null && preview != null) {
            fading.restart();
            operator.place(from.name(), from.xMeters(), from.yMeters(), from.headingRadians(), answer -> {});
        }
    }

    private String reason(Placement answer) {
        return switch (answer) {
            case OCCUPIED -> texts.of("place.occupied");
            case OUTSIDE -> texts.of("place.outside");
            case MOVING -> texts.of("place.moving");
            case DONE -> "";
        };
    }

    /** Shows the place for a robot; null shows nothing. */
    public void show(RobotPreview newPreview) {
        preview = newPreview;
        changed.run();
    }
}
