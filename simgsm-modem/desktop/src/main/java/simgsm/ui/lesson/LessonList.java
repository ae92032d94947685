package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonException;
import simgsm.lesson.LessonLibrary;
import simgsm.lesson.LessonTexts;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.glossary.GlossaryText;
import simgsm.ui.pane.WrappedColumn;

/**
 * All lessons with title, minutes, subject, a button to open them, and one for the teacher's sheet where these are shown. Needs no
 * display.
 */
public final class LessonList extends JPanel {
    /** User actions on a lesson. */
    public interface Actions {
        void open(String name);

        /** @param markdown the teacher's sheet */
        void showSheet(String title, String markdown);
    }

    private final LessonLibrary library;
    private final Locale language;
    private final TextBundle words;
    private final boolean hasSheets;
    private final Actions actions;

    /** @param hasSheets whether the teacher's sheets, which have the answers, are shown */
    public LessonList(LessonLibrary library, Locale language, boolean hasSheets, Actions actions) {
        super(new BorderLayout());
        this.hasSheets = hasSheets;
        this.library = library;
        this.language = language;
        this.actions = actions;
        words = DesktopTexts.in(language);
        JPanel column = Arrange.column(
                Theme.GRID, library.names().stream().map(this::row).toArray(Component[]::new));
        column.setBorder(Theme.padding(12));
        add(new VerticalScrollPane(new WrappedColumn(column)).bare(), BorderLayout.CENTER);
        Theme.styled(this, panel -> panel.setBackground(Theme.color(Ink.SURFACE)));
    }

    private Component row(String name) {
        GlossaryText text = GlossaryText.ofExplanations("lessons.title." + name);
        try {
            Lesson lesson = library.lesson(name);
            LessonTexts texts = library.texts(lesson, language);
            String title = texts.of("title");
            text.show(title + " (" + words.of("lesson.minutes", Integer.toString(lesson.minutes())) + ")");
            List<Component> lines = new ArrayList<>(List.of(text.bold()));
            texts.find("about").ifPresent(about -> lines.add(line(name, about)));
            List<Component> parts =
                    new ArrayList<>(List.of(Arrange.growing(Arrange.column(0, lines.toArray(Component[]::new)))));
            library.sheet(name, language)
                    .filter(sheet -> hasSheets)
                    .ifPresent(sheet ->
                            parts.add(button("lessons.sheet", name, title, () -> actions.showSheet(title, sheet))));
            parts.add(button("lessons.open", name, title, () -> actions.open(name)));
            return Arrange.row(Theme.GRID, parts.toArray(Component[]::new));
        } catch (LessonException e) {
            // A teacher's own lesson with a fault.
            text.show(e.getMessage());
            return text;
        }
    }

    /** The lesson's subject, below its title. */
    private static Component line(String name, String about) {
        GlossaryText line = GlossaryText.ofExplanations("lessons.about." + name);
        line.show(about);
        return line;
    }

    /** A button of one row, at the top of the lesson's lines. */
    private Component button(String key, String lesson, String title, Runnable act) {
        UserAction action = new UserAction(key + "." + lesson, words.of(key), act);
        JButton button = ComponentNames.name(new JButton(action), key + "." + lesson, words.of(key) + ": " + title);
        return Arrange.column(0, button, Arrange.spring());
    }
}
