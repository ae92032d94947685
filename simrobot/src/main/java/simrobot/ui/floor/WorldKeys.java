package simrobot.ui.floor;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** The floor by keyboard: arrows pan, plus and minus zoom, Home fits; with Alt the arrows move the robot, Page keys turn it. */
final class WorldKeys {
    private static final double PAN_UNITS = 48;
    private static final double NUDGE_METERS = 0.1;
    private static final double RULER_METERS = 0.05;
    private static final double TURN_RADIANS = Math.toRadians(5);

    private WorldKeys() {}

    static void install(WorldView view) {
        pan(view, KeyEvent.VK_LEFT, 1, 0);
        pan(view, KeyEvent.VK_RIGHT, -1, 0);
        pan(view, KeyEvent.VK_UP, 0, 1);
        pan(view, KeyEvent.VK_DOWN, 0, -1);
        bind(view, "world.in", () -> view.zoom(1.25), stroke(KeyEvent.VK_PLUS), stroke(KeyEvent.VK_ADD), equals());
        bind(view, "world.out", () -> view.zoom(0.8), stroke(KeyEvent.VK_MINUS), stroke(KeyEvent.VK_SUBTRACT));
        bind(view, "world.fit", view::fit, stroke(KeyEvent.VK_HOME));
        bind(view, "world.letGo", () -> view.measure(null), stroke(KeyEvent.VK_ESCAPE));
        nudge(view, KeyEvent.VK_LEFT, -NUDGE_METERS, 0, 0);
        nudge(view, KeyEvent.VK_RIGHT, NUDGE_METERS, 0, 0);
        nudge(view, KeyEvent.VK_UP, 0, NUDGE_METERS, 0);
        nudge(view, KeyEvent.VK_DOWN, 0, -NUDGE_METERS, 0);
        nudge(view, KeyEvent.VK_PAGE_UP, 0, 0, TURN_RADIANS);
        nudge(view, KeyEvent.VK_PAGE_DOWN, 0, 0, -TURN_RADIANS);
    }

    private static void pan(WorldView view, int key, int dx, int dy) {
        bind(view, "world.pan." + key, () -> arrow(view, dx, dy, false), stroke(key));
        bind(
                view,
                "world.ruler." + key,
                () -> arrow(view, dx, dy, true),
                KeyStroke.getKeyStroke(key, InputEvent.SHIFT_DOWN_MASK));
    }

    /** While the ruler lies there its end moves, with Shift its beginning; else the view does. */
    private static void arrow(WorldView view, int dx, int dy, boolean shifted) {
        if (view.ruler() != null) {
            view.measure(view.ruler().movedBy(shifted, -dx * RULER_METERS, dy * RULER_METERS));
        } else {
            view.look(view.viewport().draggedBy(dx * Theme.exact(PAN_UNITS), dy * Theme.exact(PAN_UNITS)));
        }
    }

    private static void nudge(WorldView view, int key, double dx, double dy, double turn) {
        KeyStroke stroke = KeyStroke.getKeyStroke(key, InputEvent.ALT_DOWN_MASK);
        bind(view, "world.nudge." + key, () -> view.nudge(dx, dy, turn), stroke);
    }

    private static void bind(WorldView view, String id, Runnable deed, KeyStroke... strokes) {
        new UserAction(id, id, deed).bind(view, JComponent.WHEN_FOCUSED, strokes);
    }

    private static KeyStroke stroke(int key) {
        return KeyStroke.getKeyStroke(key, 0);
    }

    private static KeyStroke equals() {
        return KeyStroke.getKeyStroke(KeyEvent.VK_EQUALS, 0);
    }
}
