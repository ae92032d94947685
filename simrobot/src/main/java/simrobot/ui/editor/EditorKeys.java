package simrobot.ui.editor;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.editor.Draft;
import simrobot.editor.Edits;

/**
 * The editor's floor by keyboard: arrows move the selected item by a step of the raster, or pan; Insert makes an item in the
 * middle; Delete deletes; Escape lets go.
 */
final class EditorKeys {
    private static final double PAN_UNITS = 48;
    private static final double STEP_WITHOUT_RASTER_METERS = 0.01;

    private EditorKeys() {}

    static void install(EditorView floor, EditorMouse mouse) {
        arrow(floor, KeyEvent.VK_LEFT, -1, 0);
        arrow(floor, KeyEvent.VK_RIGHT, 1, 0);
        arrow(floor, KeyEvent.VK_UP, 0, 1);
        arrow(floor, KeyEvent.VK_DOWN, 0, -1);
        bind(floor, "editor.in", () -> floor.zoom(1.25), KeyEvent.VK_PLUS, KeyEvent.VK_ADD, KeyEvent.VK_EQUALS);
        bind(floor, "editor.out", () -> floor.zoom(0.8), KeyEvent.VK_MINUS, KeyEvent.VK_SUBTRACT);
        bind(floor, "editor.all", floor::fit, KeyEvent.VK_HOME);
        bind(floor, "editor.insert", floor::makeInTheMiddle, KeyEvent.VK_INSERT, KeyEvent.VK_ENTER);
        bind(
                floor,
                "editor.erase",
                () -> {
                    floor.draft().deleteSelected();
                    floor.tell();
                },
                KeyEvent.VK_DELETE,
                KeyEvent.VK_BACK_SPACE);
        bind(
                floor,
                "editor.letGo",
                () -> {
                    if (!mouse.cancel()) {
                        floor.draft().select(null);
                        floor.take(EditorTool.SELECT);
                    }
                    floor.tell();
                },
                KeyEvent.VK_ESCAPE);
    }

    private static void arrow(EditorView floor, int key, int dx, int dy) {
        bind(floor, "editor.arrow." + key, () -> arrow(floor, dx, dy), key);
        // with Ctrl the view moves also while something is selected
        new UserAction("editor.pan." + key, "", () -> pan(floor, dx, dy))
                .bind(floor, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(key, InputEvent.CTRL_DOWN_MASK));
    }

    private static void arrow(EditorView floor, int dx, int dy) {
        Draft draft = floor.draft();
        if (draft.selected().isPresent()) {
            double raster = floor.snap().stepMeters();
            double step = raster == 0 ? STEP_WITHOUT_RASTER_METERS : raster;
            draft.change(Edits.moved(draft.settled(), draft.selected().get(), dx * step, dy * step));
            floor.tell();
        } else {
            pan(floor, dx, dy);
        }
    }

    private static void pan(EditorView floor, int dx, int dy) {
        floor.look(floor.viewport().draggedBy(-dx * Theme.exact(PAN_UNITS), dy * Theme.exact(PAN_UNITS)));
    }

    private static void bind(EditorView floor, String id, Runnable deed, int... keys) {
        UserAction act = new UserAction(id, id, deed);
        for (int key : keys) {
            act.bind(floor, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
        }
    }
}
