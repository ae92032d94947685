package simgsm.phone.ui;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.HierarchyEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeListener;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import javax.swing.AbstractAction;
import javax.swing.ActionMap;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.phone.screen.PhoneKey;
import simgsm.ui.CommandGroup;
import simgsm.ui.UserAction;

/**
 * Maps the computer's keyboard to the handset: typed characters are passed on in any keyboard layout; Enter, Escape
 * and the arrows are keys. A character remains pressed until a key is released or the focus leaves the panel, since
 * releases are not received after that. The keyboard's repetition of a phone key's symbol is ignored.
 */
final class Keyboard {
    private static final String FOCUS_OWNER = "focusOwner";
    private static final char NONE = '\0';

    private static final Map<Integer, PhoneKey> KEYS = Map.ofEntries(
            Map.entry(KeyEvent.VK_ESCAPE, PhoneKey.END),
            Map.entry(KeyEvent.VK_F6, PhoneKey.CALL),
            Map.entry(KeyEvent.VK_LEFT, PhoneKey.LEFT),
            Map.entry(KeyEvent.VK_RIGHT, PhoneKey.RIGHT),
            Map.entry(KeyEvent.VK_UP, PhoneKey.UP),
            Map.entry(KeyEvent.VK_DOWN, PhoneKey.DOWN),
            Map.entry(KeyEvent.VK_F2, PhoneKey.MESSAGE),
            Map.entry(KeyEvent.VK_F3, PhoneKey.MENU),
            Map.entry(KeyEvent.VK_CONTEXT_MENU, PhoneKey.MENU),
            Map.entry(KeyEvent.VK_F4, PhoneKey.SOFT_LEFT),
            Map.entry(KeyEvent.VK_F5, PhoneKey.SOFT_RIGHT));

    /** Keys not listed by the help: the key's name is its function. */
    private static final Set<PhoneKey> ARROWS = EnumSet.of(PhoneKey.LEFT, PhoneKey.RIGHT, PhoneKey.UP, PhoneKey.DOWN);

    private final HandsetControls controls;
    private char down = NONE;

    private Keyboard(HandsetControls controls) {
        this.controls = controls;
    }

    /**
     * Binds the keyboard to a panel and to every focused component in it. The help lists keys by the texts of phone
     * keys.
     */
    static void install(JComponent panel, TextBundle texts, HandsetControls controls) {
        Keyboard keyboard = new Keyboard(controls);
        InputMap inputs = new Inputs();
        inputs.setParent(panel.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT));
        ActionMap actions = panel.getActionMap();
        actions.put("typed", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                keyboard.typed(event);
            }
        });
        actions.put("released", new UserAction("released", "", keyboard::release));
        inputs.put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0, false), "enter.down");
        inputs.put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0, true), "enter.up");
        actions.put("enter.down", new UserAction("enter.down", "", controls::enterDown));
        actions.put("enter.up", new UserAction("enter.up", "", controls::enterUp));
        inputs.put(KeyStroke.getKeyStroke(KeyEvent.VK_BACK_SPACE, 0, false), "erase");
        inputs.put(KeyStroke.getKeyStroke(KeyEvent.VK_BACK_SPACE, 0, true), "none");
        actions.put("erase", new UserAction("erase", "", controls::eraseDown));
        // the menu lists them in this order
        new TreeMap<>(KEYS).forEach((code, key) -> {
            String name = PhoneKeyButton.nameOf(key);
            String meaning =
                    ARROWS.contains(key) ? "" : texts.of("key." + key.name().toLowerCase(Locale.ROOT));
            inputs.put(KeyStroke.getKeyStroke(code, 0, false), name + ".down");
            inputs.put(KeyStroke.getKeyStroke(code, 0, true), name + ".up");
            UserAction press =
                    new UserAction(name + ".down", meaning, () -> controls.keyDown(key)).in(CommandGroup.CALL);
            actions.put(press.id(), press);
            actions.put(name + ".up", new UserAction(name + ".up", "", () -> controls.keyUp(key)));
        });
        panel.setInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, inputs);
        keyboard.watchFocus(panel);
        panel.setFocusable(true);
    }

    /** Listens as long as the panel is part of a window. */
    private void watchFocus(JComponent panel) {
        PropertyChangeListener moved = change -> {
            Component owner = (Component) change.getNewValue();
            if (owner == null || !SwingUtilities.isDescendingFrom(owner, panel)) {
                release();
            }
        };
        panel.addHierarchyListener(event -> {
            if ((event.getChangeFlags() & HierarchyEvent.DISPLAYABILITY_CHANGED) != 0) {
                KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
                focus.removePropertyChangeListener(FOCUS_OWNER, moved);
                if (panel.isDisplayable()) {
                    focus.addPropertyChangeListener(FOCUS_OWNER, moved);
                }
            }
        });
    }

    private void typed(ActionEvent event) {
        boolean commanded = (event.getModifiers() & (ActionEvent.CTRL_MASK | ActionEvent.META_MASK)) != 0;
        String text = event.getActionCommand();
        if (commanded || text == null || text.length() != 1) {
            return;
        }
        char character = text.charAt(0);
        if ((event.getModifiers() & ActionEvent.ALT_MASK) != 0 && isKeyOfWindow(character)) {
            return;
        }
        if (character == down && PhoneKey.ofSymbol(character).isPresent()) {
            return;
        }
        release();
        down = character;
        controls.charDown(character);
    }

    /** Alt with a letter or digit is a key of the window, such as Alt+2; some keyboards write # with it. */
    private static boolean isKeyOfWindow(char sign) {
        return sign < 0x80 && Character.isLetterOrDigit(sign);
    }

    private void release() {
        if (down != NONE) {
            controls.charUp(down);
            down = NONE;
        }
    }

    /**
     * Returns "typed" for every character and "released" for the release of every key without a binding of its own. For keys
     * without a code, such as accented letters, Swing also asks for a stroke without a character, which is ignored.
     */
    private static final class Inputs extends InputMap {
        @Override
        public Object get(KeyStroke stroke) {
            Object bound = super.get(stroke);
            if (bound != null) {
                return bound;
            }
            if (stroke.getKeyEventType() == KeyEvent.KEY_TYPED && stroke.getKeyChar() != KeyEvent.CHAR_UNDEFINED) {
                boolean command = (stroke.getModifiers() & InputEvent.CTRL_DOWN_MASK) != 0;
                return command || Character.isISOControl(stroke.getKeyChar()) ? null : "typed";
            }
            return stroke.isOnKeyRelease() ? "released" : null;
        }
    }
}
