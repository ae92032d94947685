package simrobot.ui.panel;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JOptionPane;
import javax.swing.JPopupMenu;
import simgsm.console.TextBundle;
import simgsm.ui.Symbol;
import simgsm.ui.UserAction;
import simrobot.ui.EventThread;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;
import simrobot.ui.ToolButtons;

/** The button that exports the world as PNG or SVG, or the selected robot's track as CSV. */
final class ExportChoice {
    private final TextBundle texts;
    private final OperatorActions operator;
    private final JButton button = new JButton();
    private String robot = "";
    private Path world = Path.of("world.map");

    ExportChoice(TextBundle texts, OperatorActions operator) {
        this.texts = texts;
        this.operator = operator;
        UserAction action = new UserAction("tool.export", texts.of("tool.export"), this::showMenu)
                .with(Symbol.DOWN.icon(12))
                .onKey(button, KeyEvent.VK_E, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
        ToolButtons.button(button, action, texts.of("tool.export.word"));
        button.setHorizontalTextPosition(JButton.LEADING);
    }

    JButton component() {
        return button;
    }

    void show(String selected, Path worldFile) {
        robot = selected;
        world = worldFile;
    }

    private void showMenu() {
        menu().show(button, 0, button.getHeight());
    }

    JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        menu.add(new UserAction("export.png", texts.of("export.png"), () -> choose("png", worldName())));
        menu.add(new UserAction("export.svg", texts.of("export.svg"), () -> choose("svg", worldName())));
        UserAction track = new UserAction("export.csv", texts.of("export.csv", robot), () -> choose("csv", robot));
        track.setEnabled(!robot.isEmpty());
        menu.add(track);
        return menu;
    }

    private String worldName() {
        return String.valueOf(world.getFileName()).replaceFirst("\\.[^.]*$", "");
    }

    private void choose(String ending, String name) {
        FileDialogs.save(texts, button, Path.of(name + "." + ending), ending.toUpperCase(Locale.ROOT), ending)
                .ifPresent(file ->
                        operator.export(robot, file, EventThread.onEventThread(refusal -> showResult(file, refusal))));
    }

    private void showResult(Path file, Optional<String> refusal) {
        refusal.ifPresent(
                why -> JOptionPane.showMessageDialog(button, why, texts.of("tool.export"), JOptionPane.ERROR_MESSAGE));
        if (refusal.isEmpty()) {
            operator.tell(texts.of("export.done", file));
        }
    }
}
