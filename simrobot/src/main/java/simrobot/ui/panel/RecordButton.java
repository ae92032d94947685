package simrobot.ui.panel;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JToggleButton;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.CommandGroup;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;
import simrobot.ui.ToolButtons;

/** The button that records the session to a file until it is pressed again. */
final class RecordButton {
    private static final String ENDING = "rec";

    private final TextBundle texts;
    private final OperatorActions operator;
    private final JToggleButton button = new JToggleButton();
    private Optional<Path> recording = Optional.empty();
    private boolean known;

    RecordButton(TextBundle texts, OperatorActions operator) {
        this.texts = texts;
        this.operator = operator;
        UserAction action = new UserAction("tool.record", texts.of("tool.record"), this::press)
                .in(CommandGroup.WORLD)
                .with(Symbol.RECORD.icon())
                .onKey(button, KeyEvent.VK_K, InputEvent.CTRL_DOWN_MASK);
        ToolButtons.icon(button, action);
    }

    JToggleButton component() {
        return button;
    }

    /** Shows the state of the recording, not the last click. */
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
        FileDialogs.save(texts, button, Path.of("session." + ENDING), texts.of("tool.record.files"), ENDING)
                .ifPresent(file -> operator.record(Optional.of(file)));
    }
}
