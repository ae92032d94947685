package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.awt.Component;
import java.awt.DefaultKeyboardFocusManager;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.phone.screen.Screen;
import simgsm.ui.UserAction;

/** The computer's keyboard as the handset's. */
class KeyboardTest {
    private final PanelBench bench = new PanelBench(Locale.ENGLISH);

    private Object bindingOf(KeyStroke stroke) {
        return bench.panel
                .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .get(stroke);
    }

    private void strike(KeyStroke stroke, String character, int modifiers) {
        Object name = bindingOf(stroke);
        Action action = bench.panel.getActionMap().get(name);
        action.actionPerformed(new ActionEvent(bench.panel, ActionEvent.ACTION_PERFORMED, character, modifiers));
    }

    private void type(char character) {
        strike(KeyStroke.getKeyStroke(character), String.valueOf(character), 0);
    }

    private void letGo() {
        strike(KeyStroke.getKeyStroke(KeyEvent.VK_5, 0, true), null, 0);
    }

    @Test
    void theMenuListsTheKeysOfThePhoneInTheirOrderAndTheEvents() {
        List<String> listed = Stream.of(bench.panel.getActionMap().keys())
                .map(bench.panel.getActionMap()::get)
                .filter(UserAction.class::isInstance)
                .map(UserAction.class::cast)
                .filter(action -> action.group().isPresent() && !action.name().isBlank())
                .sorted(Comparator.comparing(
                                (UserAction action) -> action.group().orElseThrow())
                        .thenComparing(UserAction::number))
                .map(UserAction::name)
                .toList();
        assertEquals(
                List.of(
                        "Hang up",
                        "Write a message",
                        "Left key of the display",
                        "Right key of the display",
                        "Call",
                        "Menu",
                        "Events"),
                listed);
    }

    @ParameterizedTest
    @CsvSource({
        "F2, Write a message",
        "F3, Menu",
        "F4, Left key of the display",
        "F5, Right key of the display",
        "F6, Call",
        "ESCAPE, Hang up"
    })
    void theHelpCanNameTheKeysOfThePhone(String key, String meaning) {
        Object name = bindingOf(KeyStroke.getKeyStroke(key));
        assertEquals(meaning, ((UserAction) bench.panel.getActionMap().get(name)).name());
    }

    @Test
    void digitsStarAndHashAreTypedWhateverTheLayout() {
        for (char key : "0123456789*#".toCharArray()) {
            type(key);
            letGo();
        }
        assertEquals("0123456789*#", bench.bench.snapshot().typed());
    }

    @Test
    void aDigitWithAltIsAKeyOfTheWindowAndAHashWithItIsAHash() {
        for (char sign : "2#".toCharArray()) {
            SwingUtilities.processKeyBindings(new KeyEvent(
                    bench.panel, KeyEvent.KEY_TYPED, 0, InputEvent.ALT_DOWN_MASK, KeyEvent.VK_UNDEFINED, sign));
        }
        assertEquals("#", bench.bench.snapshot().typed());
    }

    @Test
    void aKeyThatRepeatsWhileHeldIsOnePress() {
        type('5');
        type('5');
        type('5');
        assertEquals("5", bench.bench.snapshot().typed());
    }

    @Test
    void theSameKeyPressedTwiceIsTwoPresses() {
        type('5');
        letGo();
        type('5');
        assertEquals("55", bench.bench.snapshot().typed());
    }

    /** Tells listeners that the focus has moved, as the desktop does when another window is chosen. */
    private static final class MovedFocus extends DefaultKeyboardFocusManager {
        void to(Component owner) {
            firePropertyChange("focusOwner", null, owner);
        }
    }

    @Test
    void aKeyHeldWhileTheFocusGoesElsewhereIsLetGo() {
        KeyboardFocusManager before = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        MovedFocus focus = new MovedFocus();
        KeyboardFocusManager.setCurrentKeyboardFocusManager(focus);
        try {
            bench.panel.addNotify();
            type('5');
            focus.to(bench.find("key.5"));
            type('5');
            assertEquals("5", bench.bench.snapshot().typed(), "still held");
            focus.to(new JPanel());
            type('5');
            assertEquals("55", bench.bench.snapshot().typed(), "pressed again");
        } finally {
            KeyboardFocusManager.setCurrentKeyboardFocusManager(before);
        }
    }

    @ParameterizedTest
    @CsvSource({
        KeyEvent.VK_ENTER + ", ENTER",
        KeyEvent.VK_ESCAPE + ", END",
        KeyEvent.VK_F6 + ", CALL",
        KeyEvent.VK_F4 + ", SOFT_LEFT",
        KeyEvent.VK_F5 + ", SOFT_RIGHT",
        KeyEvent.VK_UP + ", UP",
        KeyEvent.VK_F2 + ", MESSAGE",
        KeyEvent.VK_F3 + ", MENU"
    })
    void otherKeysAreKeysOfTheHandset(int code, String key) {
        strike(KeyStroke.getKeyStroke(code, 0, false), null, 0);
        strike(KeyStroke.getKeyStroke(code, 0, true), null, 0);
        assertEquals(List.of("down " + key, "up " + key), bench.acts);
    }

    @Test
    void backspaceErasesAndThenGoesBack() {
        type('5');
        letGo();
        strike(KeyStroke.getKeyStroke(KeyEvent.VK_BACK_SPACE, 0, false), null, 0);
        assertEquals("", bench.bench.snapshot().typed());
        strike(KeyStroke.getKeyStroke(KeyEvent.VK_F2, 0, false), null, 0);
        strike(KeyStroke.getKeyStroke(KeyEvent.VK_BACK_SPACE, 0, false), null, 0);
        assertEquals(new Screen.HomeView(), bench.bench.snapshot().screen());
    }

    @Test
    void lettersAreWrittenInAMessage() {
        strike(KeyStroke.getKeyStroke(KeyEvent.VK_F2, 0, false), null, 0);
        "Hola, \u00f1and\u00fa".chars().forEach(letter -> type((char) letter));
        assertEquals(
                "Hola, \u00f1and\u00fa",
                ((Screen.Writing) bench.bench.snapshot().screen()).text());
    }

    private void dispatch(int id, int code, char character) {
        SwingUtilities.processKeyBindings(new KeyEvent(bench.panel, id, 0, 0, code, character));
    }

    /** As Swing sees a key: pressed, typed and let go. */
    private void strikeForReal(int code, char character) {
        dispatch(KeyEvent.KEY_PRESSED, code, character);
        dispatch(KeyEvent.KEY_TYPED, KeyEvent.VK_UNDEFINED, character);
        dispatch(KeyEvent.KEY_RELEASED, code, character);
    }

    @Test
    void lettersWithoutAKeyCodeAreTypedOnce() {
        dispatch(KeyEvent.KEY_PRESSED, KeyEvent.VK_F2, KeyEvent.CHAR_UNDEFINED);
        strikeForReal(KeyEvent.VK_A, 'a');
        strikeForReal(KeyEvent.VK_UNDEFINED, '\u00f1');
        strikeForReal(KeyEvent.VK_UNDEFINED, '\u00e7');
        strikeForReal(KeyEvent.VK_UNDEFINED, '\u20ac');
        strikeForReal(KeyEvent.VK_UNDEFINED, '\u20ac');
        assertEquals(
                "a\u00f1\u00e7\u20ac\u20ac",
                ((Screen.Writing) bench.bench.snapshot().screen()).text());
    }

    @Test
    void enterIsTheKeyboardsOwnEvenWhereADigitKeyHasTheFocus() {
        JComponent five = (JComponent) bench.find("key.5");
        SwingUtilities.processKeyBindings(new KeyEvent(five, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_ENTER, '\n'));
        assertEquals(List.of("down ENTER"), bench.acts);
    }

    @Test
    void tooltipsNameTheKeyboardsKeys() {
        assertEquals("Write a message (F2)", ((JComponent) bench.find("key.message")).getToolTipText());
        assertEquals("Menu (F3)", ((JComponent) bench.find("key.menu")).getToolTipText());
        assertEquals("Hang up (Esc)", ((JComponent) bench.find("key.end")).getToolTipText());
        assertEquals("Call (Enter, F6)", ((JComponent) bench.find("key.call")).getToolTipText());
    }

    @Test
    void whatIsTypedWithControlIsACommandAndNoText() {
        strike(KeyStroke.getKeyStroke('+'), "+", ActionEvent.CTRL_MASK);
        assertEquals(List.of(), bench.acts);
    }

    @Test
    void controlCharactersAreNotTyped() {
        assertNull(bindingOf(KeyStroke.getKeyStroke('\t')));
        assertNull(bindingOf(KeyStroke.getKeyStroke((char) 0x1b)));
    }
}
