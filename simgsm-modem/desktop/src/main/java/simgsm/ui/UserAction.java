package simgsm.ui;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;

/** A user action with its name, description, mnemonic, icon and keys, for buttons, menus and key bindings. */
public final class UserAction extends AbstractAction {
    private static final String GROUP = "group";
    private static final AtomicInteger MADE = new AtomicInteger();

    private final int number = MADE.incrementAndGet();
    private final Runnable task;

    /**
     * Creates an action.
     *
     * @param id name in input maps and tests, as {@code phone.call}
     * @param name shown in menus and on buttons; {@code &} precedes the mnemonic
     */
    public UserAction(String id, String name, Runnable task) {
        this.task = task;
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

    /** An action with the texts of a key: its name, and at {@code KEY.why} its tool tip. */
    public static UserAction of(TextBundle texts, String id, String key, Runnable task) {
        return new UserAction(id, texts.of(key), task).described(texts.of(key + ".why"));
    }

    /** Sets the tool tip. */
    public UserAction described(String description) {
        putValue(SHORT_DESCRIPTION, description);
        return this;
    }

    public UserAction with(Icon icon) {
        putValue(SMALL_ICON, icon);
        return this;
    }

    /** Shows a key in menus; does not bind it. */
    public UserAction with(KeyStroke accelerator) {
        putValue(ACCELERATOR_KEY, accelerator);
        return this;
    }

    /** Puts it into the window's menu, in this submenu. */
    public UserAction in(CommandGroup group) {
        putValue(GROUP, group);
        return this;
    }

    public Optional<CommandGroup> group() {
        return Optional.ofNullable((CommandGroup) getValue(GROUP));
    }

    /** Its place among all actions, in the order in which they were made. */
    public int number() {
        return number;
    }

    /** Shows in menus whether what it switches is on. */
    public void setOn(boolean on) {
        putValue(SELECTED_KEY, on);
    }

    public String id() {
        return (String) getValue(ACTION_COMMAND_KEY);
    }

    public String name() {
        return (String) getValue(NAME);
    }

    /** Binds keys everywhere in the anchor's window. */
    public void bindInWindow(JComponent anchor, KeyStroke... strokes) {
        bind(anchor, JComponent.WHEN_IN_FOCUSED_WINDOW, strokes);
    }

    /**
     * Binds a key everywhere in the anchor's window; the tool tip is the name with the key. @param modifiers of
     * {@link java.awt.event.InputEvent}
     */
    public UserAction onKey(JComponent anchor, int key, int modifiers) {
        bindInWindow(anchor, KeyStroke.getKeyStroke(key, modifiers));
        return described(
                name() + "  (" + InputEvent.getModifiersExText(modifiers) + "+" + KeyEvent.getKeyText(key) + ")");
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
            task.run();
        }
    }
}
