package simgsm.ui.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.draw.Appearance;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonLibrary;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;

class LessonPanelTest {
    private final List<String> done = new ArrayList<>();

    private final LessonActs acts = new LessonActs() {
        @Override
        public void predict(String text) {
            done.add("predict " + text);
        }

        @Override
        public void answer(String name, String text) {
            done.add("answer " + name + " " + text);
        }

        @Override
        public void act(String name, String input) {
            done.add("act " + name + " " + input);
        }

        @Override
        public void startProgram(String name) {
            done.add("start " + name);
        }

        @Override
        public void stopProgram(String name) {
            done.add("stop " + name);
        }

        @Override
        public void save(String student) {
            done.add("save " + student);
        }

        @Override
        public void open(String lesson) {
            done.add("open " + lesson);
        }
    };

    @BeforeEach
    void look() {
        Theme.install(Appearance.LIGHT);
    }

    private LessonPanel panel(String name, String language) throws Exception {
        Locale locale = Locale.forLanguageTag(language);
        return new LessonPanel(
                LessonLibrary.lesson(name), LessonLibrary.texts(name, locale), locale, text -> text, acts);
    }

    private static LessonView view(String name, LessonView.StepState state) throws Exception {
        Lesson lesson = LessonLibrary.lesson(name);
        return new LessonView(
                5,
                true,
                lesson.steps().stream()
                        .map(step -> new LessonView.StepView(step.name(), state, false))
                        .toList(),
                Set.of(),
                "");
    }

    static Stream<String> names() {
        return LessonLibrary.names().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyControlOfEveryLessonIsNamedInBothLanguages(String name) throws Exception {
        for (String language : List.of("en", "es")) {
            LessonPanel panel = panel(name, language);
            panel.show(view(name, LessonView.StepState.OPEN));
            assertEquals(List.of(), ComponentNames.unnamed(panel));
        }
    }

    @Test
    void theStepsAppearWithThePredictionAndTheQuestionAtTheEnd() throws Exception {
        LessonPanel panel = panel("twelve-keys", "en");
        panel.show(new LessonView(
                5, false, view("twelve-keys", LessonView.StepState.OPEN).steps(), Set.of(), ""));
        assertFalse(isShown(panel, "lesson.lamp.call"));
        panel.show(view("twelve-keys", LessonView.StepState.OPEN));
        assertTrue(isShown(panel, "lesson.lamp.call"));
        assertFalse(isShown(panel, "lesson.question"));
        panel.show(view("twelve-keys", LessonView.StepState.DONE));
        assertTrue(isShown(panel, "lesson.question"));
        Lamp lamp = (Lamp) ComponentNames.find(panel, "lesson.lamp.call").orElseThrow();
        assertEquals("done", lamp.word());
    }

    private static boolean isShown(LessonPanel panel, String name) {
        for (java.awt.Component each = ComponentNames.find(panel, name).orElseThrow();
                each != panel;
                each = each.getParent()) {
            if (!each.isVisible()) {
                return false;
            }
        }
        return true;
    }

    @Test
    void fieldsAndButtonsPassOnWhatTheStudentDoes() throws Exception {
        LessonPanel panel = panel("store-and-forward", "en");
        panel.show(view("store-and-forward", LessonView.StepState.OPEN));
        type(panel, "lesson.predict", "nothing");
        type(panel, "lesson.answer.first-time", " a ");
        ((JButton) ComponentNames.find(panel, "lesson.program.robot").orElseThrow()).doClick();
        ((JButton) ComponentNames.find(panel, "lesson.save").orElseThrow()).doClick();
        assertEquals(List.of("predict nothing", "answer first-time a", "start robot", "save "), done);
    }

    private static void type(LessonPanel panel, String name, String text) {
        JTextField field = (JTextField) ComponentNames.find(panel, name).orElseThrow();
        field.setText(text);
        field.postActionEvent();
    }

    @Test
    void aTermOfTheGlossaryIsExplainedAtAClick() throws Exception {
        GlossaryText text =
                new GlossaryText("sample", java.util.Optional.of(simgsm.lesson.Glossary.in(Locale.ENGLISH)), done::add);
        text.show("A SUBMIT is a TPDU");
        text.fireHyperlinkUpdate(new javax.swing.event.HyperlinkEvent(
                text, javax.swing.event.HyperlinkEvent.EventType.ACTIVATED, null, "SUBMIT"));
        assertEquals(List.of("SUBMIT"), done);
        assertEquals("A SUBMIT is a TPDU", text.getText());
    }

    @Test
    void theTableOfAClassShowsTheNewestResults() {
        ClassPanel panel = new ClassPanel(Locale.ENGLISH);
        panel.show(List.of(List.of("5550100", "5550200", "1", "9", "0", "12.5")));
        panel.show(List.of(List.of("5550101", "5550201", "2", "18", "1", "")));
        JTable table = (JTable) ComponentNames.find(panel, "class.table").orElseThrow();
        assertEquals(1, table.getRowCount());
        assertEquals("5550101", table.getValueAt(0, 0));
        assertEquals(List.of(), ComponentNames.unnamed(panel));
    }

    @Test
    void theListsOfLessonsAndTermsAreNamed() {
        LessonList list = new LessonList(Locale.ENGLISH, done::add);
        assertEquals(List.of(), ComponentNames.unnamed(list));
        ((JButton) ComponentNames.find(list, "lessons.open.twelve-keys").orElseThrow()).doClick();
        assertEquals(List.of("twelve-keys"), done);
        assertEquals(List.of(), ComponentNames.unnamed(new GlossaryList(Locale.forLanguageTag("es"))));
    }
}
