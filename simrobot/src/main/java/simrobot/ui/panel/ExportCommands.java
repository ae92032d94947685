package simrobot.ui.panel;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import simgsm.console.TextBundle;
import simgsm.ui.CommandGroup;
import simgsm.ui.UserAction;
import simrobot.ui.EventThread;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;

/** The commands that export the world as PNG or SVG, or the selected robot's track as CSV. */
final class ExportCommands {
    private final TextBundle texts;
    private final OperatorActions operator;
    private final JComponent page;
    private final UserAction track;
    private String robot = "";
    private Path world = Path.of("world.map");

    /** @param page has the commands' key bindings */
    ExportCommands(TextBundle texts, OperatorActions operator, JComponent page) {
        this.texts = texts;
        this.operator = operator;
        this.page = page;
        command("export.png", () -> choose("png", worldName()))
                .onKey(page, KeyEvent.VK_E, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
        command("export.svg", () -> choose("svg", worldName()));
        track = command("export.csv", () -> choose("csv", robot));
    }

    private UserAction command(String id, Runnable task) {
        UserAction action = new UserAction(id, texts.of(id, robot), task).in(CommandGroup.WORLD);
        action.bindInWindow(page);
        return action;
    }

    void show(String selected, Path worldFile) {
        robot = selected;
        world = worldFile;
        track.setEnabled(!robot.isEmpty());
        track.putValue(UserAction.NAME, texts.of("export.csv", robot));
    }

    private String worldName() {
        return String.valueOf(world.getFileName()).replaceFirst("\\.[^.]*$", "");
    }

    private void choose(String ending, String name) {
        FileDialogs.save(texts, page, Path.of(name + "." + ending), ending.toUpperCase(Locale.ROOT), ending)
                .ifPresent(file ->
                        operator.export(robot, file, EventThread.onEventThread(refusal -> showResult(file, refusal))));
    }

    private void showResult(Path file, Optional<String> refusal) {
        refusal.ifPresent(
                why -> JOptionPane.showMessageDialog(page, why, texts.of("tool.export"), JOptionPane.ERROR_MESSAGE));
        if (refusal.isEmpty()) {
            operator.tell(texts.of("export.done", file));
        }
    }
}
