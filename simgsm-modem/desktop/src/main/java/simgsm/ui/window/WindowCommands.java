package simgsm.ui.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.ActionMap;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.ui.CommandGroup;
import simgsm.ui.UserAction;

/** The table of a window's commands, read from its components; menu and help show it. */
final class WindowCommands {
    private final Map<String, Command> byName = new LinkedHashMap<>();

    private WindowCommands() {}

    /** @param keys that perform it everywhere in the window or in a panel; those of the number pad are left out */
    record Command(UserAction action, List<KeyStroke> keys) {
        CommandGroup group() {
            return action.group().orElse(CommandGroup.VIEW);
        }

        String keysText(TextBundle texts) {
            return keys.stream().map(key -> text(key, texts)).collect(Collectors.joining(",  "));
        }

        private static String text(KeyStroke stroke, TextBundle texts) {
            return Stream.of(javaText(stroke).split("(?<=[^+])\\+"))
                    .map(name -> named(name, texts))
                    .collect(Collectors.joining("+"));
        }

        /** Java names keys in few languages, and some by a word that no keyboard bears. */
        private static String named(String javaName, TextBundle texts) {
            String key = "keyboard." + javaName.toLowerCase(Locale.ROOT).replace(' ', '_');
            String name = texts.of(key);
            return name.equals(key) ? javaName : name;
        }

        private static String javaText(KeyStroke stroke) {
            int code = stroke.getKeyCode();
            String held = InputEvent.getModifiersExText(stroke.getModifiers());
            // Java's names are words such as "Equals"; these codes equal their characters
            boolean isSign = code >= KeyEvent.VK_COMMA && code <= KeyEvent.VK_CLOSE_BRACKET;
            String key =
                    code == KeyEvent.VK_PLUS ? "+" : isSign ? String.valueOf((char) code) : KeyEvent.getKeyText(code);
            return held.isEmpty() ? key : held + "+" + key;
        }
    }

    /** The commands that have a key or a group, by group; without those of hidden pages, such as the editor's. */
    static List<Command> of(Component root) {
        WindowCommands commands = new WindowCommands();
        commands.collect(root);
        return commands.byName.values().stream()
                .filter(command ->
                        !command.keys().isEmpty() || command.action().group().isPresent())
                .sorted(Comparator.comparing(Command::group)
                        .thenComparing(command -> command.action().number()))
                .toList();
    }

    private void collect(Component component) {
        if (component instanceof JComponent bound) {
            ActionMap actions = bound.getActionMap();
            for (Object id : actions.keys() == null ? new Object[0] : actions.keys()) {
                if (actions.get(id) instanceof UserAction action) {
                    add(action, keys(bound, id));
                }
            }
        }
        if (component instanceof AbstractButton button && button.getAction() instanceof UserAction action) {
            KeyStroke mnemonic = KeyStroke.getKeyStroke(button.getMnemonic(), InputEvent.ALT_DOWN_MASK);
            add(action, button.getMnemonic() == 0 ? List.of() : List.of(mnemonic));
        }
        if (component instanceof Container container) {
            Stream.of(container.getComponents()).filter(Component::isVisible).forEach(this::collect);
        }
    }

    private void add(UserAction action, Collection<KeyStroke> keys) {
        if (!action.name().isBlank()) {
            Command command = byName.computeIfAbsent(action.name(), name -> new Command(action, new ArrayList<>()));
            keys.stream().filter(key -> !command.keys().contains(key)).forEach(command.keys()::add);
        }
    }

    private static List<KeyStroke> keys(JComponent component, Object id) {
        return Stream.of(JComponent.WHEN_IN_FOCUSED_WINDOW, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .map(component::getInputMap)
                .flatMap(inputs -> keys(inputs, id))
                .toList();
    }

    private static Stream<KeyStroke> keys(InputMap inputs, Object id) {
        KeyStroke[] all = inputs.keys();
        return Stream.of(all == null ? new KeyStroke[0] : all)
                .filter(stroke -> id.equals(inputs.get(stroke)) && !isOnKeypad(stroke))
                .sorted(Comparator.comparing(
                                (KeyStroke key) -> Command.javaText(key).length())
                        .thenComparing(Command::javaText));
    }

    /** Keys of the number pad repeat keys of the main block. */
    private static boolean isOnKeypad(KeyStroke stroke) {
        return stroke.getKeyCode() >= KeyEvent.VK_NUMPAD0 && stroke.getKeyCode() <= KeyEvent.VK_DIVIDE;
    }
}
