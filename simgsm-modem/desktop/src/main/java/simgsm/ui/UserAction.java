package simgsm.ui;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** One thing that a user can do: name, description, mnemonic, icon, whether it can be done now; shared by all its ways. */
public final class UserAction extends AbstractAction {
    private final Runnable deed;

    /**
     * @param id names the act in input maps and tests, as {@code phone.call}
     * @param name what menus and buttons show; a {@code &} stands before the mnemonic
     */
    public UserAction(String id, String name, Runnable deed) {
        this.deed = deed;
        putValue(Action.ACTION_COMMAND_KEY, id);
        int mark = name.indexOf('&');
        if (mark >= 0 && mark + 1 < name.length()) {
            putValue(NAME, name.substring(0, mark) + name.substring(mark + 1));
            putValue(MNEMONIC_KEY, (int) Character.toUpperCase(name.charAt(mark + 1)));
            putValue(DISPLAYED_MNEMONIC_INDEX_KEY, mark);
        } else {
            putValue(NAME, name);
        }
    }

    public UserAction described(String description) {
        putValue(SHORT_DESCRIPTION, description);
        return this;
    }

    public UserAction with(Icon icon) {
        putValue(SMALL_ICON, icon);
        return this;
    }

    public UserAction with(KeyStroke accelerator) {
        putValue(ACCELERATOR_KEY, accelerator);
        return this;
    }

    public String id() {
        return (String) getValue(ACTION_COMMAND_KEY);
    }

    /** Reaches the act by keys wherever the focus is in the window. */
    public void bindInWindow(JComponent anchor, KeyStroke... strokes) {
        bind(anchor, JComponent.WHEN_IN_FOCUSED_WINDOW, strokes);
    }

    /** @param condition one of JComponent's WHEN_ constants */
    public void bind(JComponent anchor, int condition, KeyStroke... strokes) {
        for (KeyStroke stroke : strokes) {
            anchor.getInputMap(condition).put(stroke, id());
        }
        anchor.getActionMap().put(id(), this);
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        if (isEnabled()) {
            deed.run();
        }
    }
}
