package simrobot.ui.panel;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.file.OpenDialog;
import simrobot.ui.OperatorActions;
import simrobot.ui.ToolButtons;

/** The button with the world's name; its menu lists the worlds in its folder. */
public final class WorldChoice {
    /** Extensions listed in a folder; a picture is opened by name, because most pictures are no worlds. */
    private static final List<String> LISTED = List.of("map", "wld", "yaml", "yml");

    private static final List<String> ENDINGS = List.of("map", "wld", "yaml", "yml", "png", "pgm");

    private final TextBundle texts;
    private final OperatorActions operator;
    private final Consumer<Boolean> editing;
    private final JButton button = new JButton();
    private final UserAction edit;
    private Path file = Path.of("");

    /** @param editing receives true to edit a new world, false to edit the current one */
    WorldChoice(TextBundle texts, OperatorActions operator, Consumer<Boolean> editing) {
        this.texts = texts;
        this.editing = editing;
        this.operator = operator;
        UserAction open = new UserAction("tool.world", texts.of("tool.world"), this::showMenu)
                .in(CommandGroup.WORLD)
                .with(Symbol.DOWN.icon(12))
                .onKey(button, KeyEvent.VK_O, InputEvent.CTRL_DOWN_MASK);
        ToolButtons.named(button, open.described(texts.of("tool.world")));
        button.setHorizontalTextPosition(JButton.LEADING);
        edit = new UserAction("world.edit", texts.of("tool.world.edit"), () -> editing.accept(false))
                .in(CommandGroup.WORLD)
                .with(KeyStroke.getKeyStroke(KeyEvent.VK_E, InputEvent.CTRL_DOWN_MASK))
                .onKey(button, KeyEvent.VK_E, InputEvent.CTRL_DOWN_MASK);
    }

    JButton component() {
        return button;
    }

    void show(Path worldFile) {
        if (!worldFile.equals(file)) {
            file = worldFile;
            button.setText(String.valueOf(worldFile.getFileName()));
            button.getAccessibleContext().setAccessibleName(texts.of("tool.world") + ": " + button.getText());
        }
    }

    private void showMenu() {
        menu().show(button, 0, button.getHeight());
    }

    public JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        List<Path> neighbours = neighbours();
        neighbours.forEach(world -> menu.add(loading(world)));
        menu.addSeparator();
        List<Path> recent = operator.recentWorlds().stream()
                .filter(world -> !neighbours.contains(world))
                .toList();
        if (!recent.isEmpty()) {
            menu.add(heading("tool.world.recent"));
            recent.forEach(
                    world -> menu.add(loading(world, texts.of("tool.world.in", world.getFileName(), folder(world)))));
            menu.addSeparator();
        }
        if (neighbours.stream()
                .noneMatch(world -> ShippedWorlds.about(texts, world).isPresent())) {
            menu.add(heading("tool.world.shipped"));
            ShippedWorlds.NAMES.forEach(name -> menu.add(loading(ShippedWorlds.FOLDER.resolve(name))));
            menu.addSeparator();
        }
        menu.add(edit);
        menu.add(new UserAction("world.new", texts.of("tool.world.new"), () -> editing.accept(true)));
        menu.addSeparator();
        menu.add(new UserAction("world.reload", texts.of("tool.world.reload"), () -> operator.load(file)));
        menu.add(new UserAction("world.open", texts.of("tool.world.open"), this::choose));
        return menu;
    }

    private JComponent heading(String key) {
        JLabel label = Theme.label(texts.of(key), Theme::small, Ink.QUIET);
        label.setBorder(Theme.padding(4, 12, 2, 12));
        return ComponentNames.name(label, key, texts.of(key));
    }

    private UserAction loading(Path world) {
        String name = String.valueOf(world.getFileName());
        return loading(
                world,
                ShippedWorlds.about(texts, world)
                        .map(about -> name + "  \u2013  " + about)
                        .orElse(name));
    }

    private UserAction loading(Path world, String shown) {
        return new UserAction("world." + world.getFileName(), shown, () -> operator.load(world));
    }

    /** The folder, relative to the user's if it is below that. */
    private static String folder(Path world) {
        Path home = Path.of(System.getProperty("user.home", ""));
        Path folder = world.getParent();
        return folder.startsWith(home) ? "~/" + home.relativize(folder) : folder.toString();
    }

    /** The worlds in the folder of this one, the shipped ones first; the built-in ones if there is no folder. */
    private List<Path> neighbours() {
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.exists(file)) {
            return ShippedWorlds.NAMES.stream().map(file::resolveSibling).toList();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(WorldChoice::isWorld)
                    .sorted(Comparator.comparingInt(WorldChoice::rank).thenComparing(Comparator.naturalOrder()))
                    .limit(30)
                    .toList();
        } catch (IOException | UncheckedIOException unreadable) {
            return List.of();
        }
    }

    private static int rank(Path world) {
        int rank = ShippedWorlds.NAMES.indexOf(world.getFileName().toString());
        return rank < 0 ? ShippedWorlds.NAMES.size() : rank;
    }

    private static boolean isWorld(Path candidate) {
        String name = candidate.getFileName().toString().toLowerCase(Locale.ROOT);
        return LISTED.stream().anyMatch(ending -> name.endsWith("." + ending));
    }

    private void choose() {
        Optional<Path> folder = Optional.of(file.toAbsolutePath().getParent());
        OpenDialog.ask(button, OpenDialog.question(folder, texts.of("tool.world.files"), ENDINGS))
                .ifPresent(operator::load);
    }
}
