package simgsm.ui.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** Language, colours and size of a window, and its remembered values. */
final class SettingsPanel extends JPanel {
    private static final List<Integer> ZOOMS = List.of(75, 100, 125, 150, 175, 200, 250, 300);
    private static final List<Locale> LANGUAGES = List.of(Locale.ENGLISH, Locale.forLanguageTag("es"));

    /**
     * Actions of the settings.
     *
     * @param language shows the window in another language; empty if its program has its own setting
     */
    record Actions(
            Optional<Consumer<Locale>> language,
            Consumer<Appearance> appearance,
            Consumer<Integer> zoomPercent,
            Optional<WindowMemory> memory) {
        /** The same, with an act before a change of language. */
        Actions beforeLanguage(Runnable first) {
            Optional<Consumer<Locale>> both = language.map(speak -> chosen -> {
                first.run();
                speak.accept(chosen);
            });
            return new Actions(both, appearance, zoomPercent, memory);
        }
    }

    SettingsPanel(Locale language, TextBundle texts, Actions actions) {
        super(new BorderLayout());
        setBorder(Theme.padding(12));
        Theme.styled(this, panel -> panel.setBackground(Theme.color(Ink.SURFACE)));
        JPanel column = Arrange.column(
                Theme.GRID,
                actions.language().isPresent()
                        ? choice(
                                "settings.language",
                                texts,
                                () -> LANGUAGES,
                                () -> Locale.forLanguageTag(language.getLanguage()),
                                each -> each.getDisplayLanguage(each),
                                actions.language().get())
                        : note("settings.language.own", texts),
                choice(
                        "settings.theme",
                        texts,
                        () -> List.of(Appearance.values()),
                        Theme::appearance,
                        each -> texts.of("theme." + each.word()),
                        actions.appearance()),
                choice(
                        "settings.zoom",
                        texts,
                        SettingsPanel::zooms,
                        SettingsPanel::zoom,
                        each -> each + " %",
                        actions.zoomPercent()),
                memory(texts, actions.memory()),
                Arrange.spring());
        add(column);
    }

    private static List<Integer> zooms() {
        return Stream.concat(ZOOMS.stream(), Stream.of(zoom()))
                .distinct()
                .sorted()
                .toList();
    }

    private static int zoom() {
        return (int) Math.round(Theme.zoom() * 100);
    }

    /** A box that shows the value in force, also after a key has changed it. */
    private static <T> Component choice(
            String key,
            TextBundle texts,
            Supplier<List<T>> values,
            Supplier<T> now,
            Function<T, String> word,
            Consumer<T> chosen) {
        JComboBox<String> box = Theme.styled(new JComboBox<>(), all -> {
            all.setModel(
                    new DefaultComboBoxModel<>(values.get().stream().map(word).toArray(String[]::new)));
            all.setSelectedIndex(values.get().indexOf(now.get()));
        });
        box.addActionListener(event -> {
            if (box.getSelectedIndex() >= 0) {
                T value = values.get().get(box.getSelectedIndex());
                if (!value.equals(now.get())) {
                    // The choice repaints the box, so it takes effect after the event.
                    SwingUtilities.invokeLater(() -> chosen.accept(value));
                }
            }
        });
        ComponentNames.name(box, key, texts.of(key));
        return Arrange.row(
                Theme.GRID, Arrange.growing(Theme.label(texts.of(key), Theme::base, Ink.TEXT)), Arrange.growing(box));
    }

    private static Component memory(TextBundle texts, Optional<WindowMemory> memory) {
        if (memory.isEmpty()) {
            return note("settings.fresh", texts);
        }
        UserAction forget = new UserAction("settings.forget", texts.of("settings.forget"), memory.get()::forget);
        JButton button = ComponentNames.name(new JButton(forget), forget.id(), forget.name());
        return Arrange.row(
                Theme.GRID,
                Arrange.growing(note("settings.remembered", texts, memory.get().folder())),
                button);
    }

    private static JTextArea note(String key, TextBundle texts, Object... values) {
        JTextArea note = HelpDialog.paragraph(texts.of(key, values));
        return ComponentNames.name(note, key, note.getText());
    }
}
