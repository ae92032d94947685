package simrobot.ui.panel;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.filechooser.FileNameExtensionFilter;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;

/** Records the session in a file that is asked for, until it is pressed again. */
final class RecordButton {
    private static final String ENDING = "rec";

    private final TextBundle texts;
    private final OperatorActions operator;
    private final JToggleButton button;
    private Optional<Path> recording = Optional.empty();
    private boolean known;

    RecordButton(TextBundle texts, OperatorActions operator) {
        this.texts = texts;
        this.operator = operator;
        UserAction act = new UserAction("tool.record", texts.of("tool.record"), this::press).with(Symbol.RECORD.icon());
        button = new JToggleButton(act);
        button.setText(null);
        button.setHideActionText(true);
        act.bindInWindow(button, KeyStroke.getKeyStroke(KeyEvent.VK_K, InputEvent.CTRL_DOWN_MASK));
        ComponentNames.name(button, "tool.record", texts.of("tool.record"));
    }

    JToggleButton component() {
        return button;
    }

    /** A switch shows what is, not what was clicked. */
    void show(Optional<Path> file) {
        button.setSelected(file.isPresent());
        if (!known || !file.equals(recording)) {
            known = true;
            recording = file;
            String words = file.map(path -> texts.of("tool.record.stop", path.getFileName()))
                    .orElse(texts.of("tool.record"));
            button.setToolTipText(words + "  (Ctrl+K)");
            button.getAccessibleContext().setAccessibleName(words);
            button.setForeground(file.isPresent() ? Theme.color(Ink.DANGER) : null);
        }
    }

    private void press() {
        button.setSelected(recording.isPresent());
        if (recording.isPresent()) {
            operator.record(Optional.empty());
            return;
        }
        JFileChooser chooser = new JFileChooser();
        chooser.setSelectedFile(new File("session." + ENDING));
        chooser.setFileFilter(new FileNameExtensionFilter(texts.of("tool.record.files"), ENDING));
        while (chooser.showSaveDialog(button) == JFileChooser.APPROVE_OPTION) {
            Path file = ExportChoice.withEnding(chooser.getSelectedFile().toPath(), ENDING);
            if (!Files.exists(file) || FileDialogs.mayReplace(texts, button, file)) {
                operator.record(Optional.of(file));
                return;
            }
        }
    }
}
