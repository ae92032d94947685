package simrobot.ui.floor;

import java.util.Optional;
import javax.swing.Timer;
import simgsm.console.TextBundle;
import simrobot.robot.Placement;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.EventThread;
import simrobot.ui.OperatorActions;

/**
 * Puts robots where the person at the window wants them. A place that is refused is shown as a ghost with the reason;
 * a robot that is let go there returns to where it was taken.
 */
public final class RobotPlacing {
    private static final int GHOST_MILLIS = 2500;

    private final OperatorActions operator;
    private final TextBundle texts;
    private final Runnable changed;
    private final Timer fading = new Timer(GHOST_MILLIS, event -> fade());
    private RobotGhost ghost;
    private RobotSnapshot taken;

    /** @param changed run when there is something else to be seen */
    RobotPlacing(OperatorActions operator, TextBundle texts, Runnable changed) {
        this.operator = operator;
        this.texts = texts;
        this.changed = changed;
        fading.setRepeats(false);
    }

    /** What is to be painted besides the robots. */
    public Optional<RobotGhost> ghost() {
        return Optional.ofNullable(ghost);
    }

    /** True while a robot is dragged. */
    public boolean holds() {
        return taken != null;
    }

    /** A robot is taken from where it stands. */
    void take(RobotSnapshot robot) {
        taken = robot;
    }

    void put(RobotSnapshot robot, double x, double y, double heading) {
        operator.place(
                robot.name(), x, y, heading, EventThread.onEventThread(answer -> answered(x, y, heading, answer)));
    }

    private void answered(double x, double y, double heading, Placement answer) {
        boolean done = answer == Placement.DONE;
        show(done ? null : new RobotGhost(x, y, heading, reason(answer), true));
        fading.stop();
        if (!done && taken == null) {
            fading.start();
        }
    }

    /** The robot is let go; where it was refused it goes back. */
    void letGo() {
        RobotSnapshot from = taken;
        taken = null;
        if (from != null && ghost != null) {
            fading.restart();
            operator.place(
                    from.name(),
                    from.xMeters(),
                    from.yMeters(),
                    from.headingRadians(),
                    EventThread.onEventThread(back -> {}));
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

    /** Shows where a robot is to be put; null shows nothing. */
    public void show(RobotGhost newGhost) {
        ghost = newGhost;
        changed.run();
    }

    private void fade() {
        show(null);
    }
}
