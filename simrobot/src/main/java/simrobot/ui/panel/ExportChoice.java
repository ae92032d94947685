package simrobot.ui.panel;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import javax.swing.filechooser.FileNameExtensionFilter;
import simgsm.console.TextBundle;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.UserAction;
import simrobot.ui.EventThread;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;

/** Saves what is to be seen: the world as PNG or SVG, the selected robot's track as CSV. */
final class ExportChoice {
    private final TextBundle texts;
    private final OperatorActions operator;
    private final JButton button;
    private String robot = "";
    private Path world = Path.of("world.map");

    ExportChoice(TextBundle texts, OperatorActions operator) {
        this.texts = texts;
        this.operator = operator;
        UserAction act = new UserAction("tool.export", texts.of("tool.export"), this::offer).with(Symbol.DOWN.icon(12));
        button = new JButton(act);
        button.setText(texts.of("tool.export.word"));
        button.setHorizontalTextPosition(JButton.LEADING);
        button.setToolTipText(texts.of("tool.export") + "  (Ctrl+X)");
        act.bindInWindow(button, KeyStroke.getKeyStroke(KeyEvent.VK_X, InputEvent.CTRL_DOWN_MASK));
        ComponentNames.name(button, "tool.export", texts.of("tool.export"));
    }

    JButton component() {
        return button;
    }

    void show(String selected, Path worldFile) {
        robot = selected;
        world = worldFile;
    }

    private void offer() {
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
        JFileChooser chooser = new JFileChooser();
        chooser.setSelectedFile(new File(name + "." + ending));
        chooser.setFileFilter(new FileNameExtensionFilter(ending.toUpperCase(Locale.ROOT), ending));
        while (chooser.showSaveDialog(button) == JFileChooser.APPROVE_OPTION) {
            Path file = withEnding(chooser.getSelectedFile().toPath(), ending);
            if (!Files.exists(file) || FileDialogs.mayReplace(texts, button, file)) {
                operator.export(robot, file, EventThread.onEventThread(refusal -> tell(file, refusal)));
                return;
            }
        }
    }

    static Path withEnding(Path file, String ending) {
        String name = String.valueOf(file.getFileName());
        boolean ended = name.toLowerCase(Locale.ROOT).endsWith("." + ending);
        return ended ? file : file.resolveSibling(name + "." + ending);
    }

    private void tell(Path file, Optional<String> refusal) {
        refusal.ifPresent(
                why -> JOptionPane.showMessageDialog(button, why, texts.of("tool.export"), JOptionPane.ERROR_MESSAGE));
        if (refusal.isEmpty()) {
            operator.tell(texts.of("export.done", file));
        }
    }
}
