package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.lesson.LessonException;
import simgsm.lesson.LessonLibrary;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** All lessons with title, minutes, and a button that opens one. Needs no display. */
public final class LessonList extends JPanel {
    /** @param open receives the name of the chosen lesson */
    public LessonList(Locale language, Consumer<String> open) {
        super(new BorderLayout());
        TextBundle words = DesktopTexts.in(language);
        List<Component> rows = new ArrayList<>();
        for (String name : LessonLibrary.names()) {
            rows.add(row(name, language, words, open));
        }
        JPanel column = Arrange.column(Theme.GRID, rows.toArray(Component[]::new));
        column.setBorder(Theme.padding(12));
        JScrollPane scroll = new JScrollPane(new LessonColumn(column));
        scroll.setBorder(null);
        scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        add(scroll, BorderLayout.CENTER);
        setBackground(Theme.color(Ink.SURFACE));
    }

    private static Component row(String name, Locale language, TextBundle words, Consumer<String> open) {
        String title;
        int minutes;
        try {
            title = LessonLibrary.texts(name, language).of("title");
            minutes = LessonLibrary.lesson(name).minutes();
        } catch (LessonException e) {
            throw new IllegalStateException(e); // part of the jar, and tested
        }
        GlossaryText text = new GlossaryText("lessons.title." + name, Optional.empty(), term -> {});
        text.show(title + " (" + words.of("lesson.minutes", Integer.toString(minutes)) + ")");
        UserAction begin = new UserAction("lessons.open." + name, words.of("lessons.open"), () -> open.accept(name));
        JButton button = ComponentNames.name(
                new JButton(begin), "lessons.open." + name, words.of("lessons.open") + ": " + title);
        return Arrange.row(Theme.GRID, Arrange.growing(text), button);
    }
}
