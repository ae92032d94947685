package simgsm.ui;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Runs one task after each change of a text field's document. */
public record DocumentChanges(Runnable changed) implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
        changed.run();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        changed.run();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
        changed.run();
    }
}
