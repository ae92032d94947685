package simgsm.ui.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JEditorPane;
import javax.swing.SwingUtilities;
import javax.swing.text.StyleConstants;
import javax.swing.text.StyledDocument;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.lesson.LessonLibrary;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.glossary.GlossaryList;
import simgsm.ui.glossary.GlossaryText;

class LessonListTest {
    private final List<String> done = new ArrayList<>();

    @BeforeEach
    void look() {
        Theme.install(Appearance.LIGHT);
    }

    private final LessonLibrary library = LessonLibrary.ofSuite();

    private LessonList list(LessonLibrary lessons) {
        return new LessonList(lessons, Locale.ENGLISH, true, new LessonList.Actions() {
            @Override
            public void open(String name) {
                done.add(name);
            }

            @Override
            public void showSheet(String title, String markdown) {
                done.add(markdown);
            }
        });
    }

    private static void press(LessonList list, String name) {
        ((JButton) ComponentNames.find(list, name).orElseThrow()).doClick();
    }

    @Test
    void aTeachersLessonThatIsWrongStandsInTheListWithItsFault(@TempDir Path folder) throws Exception {
        Path mine = Files.createDirectory(folder.resolve("mine"));
        Files.writeString(mine.resolve("lesson.txt"), "minutes 5\nstep a\nwhen phone x\n");
        LessonList list = list(LessonLibrary.with(folder));
        JEditorPane row =
                (JEditorPane) ComponentNames.find(list, "lessons.title.mine").orElseThrow();
        assertTrue(
                row.getText()
                        .endsWith("lesson.txt, line 3: expected a source of centre, student, tool, trace; found phone"),
                row.getText());
        assertTrue(ComponentNames.find(list, "lessons.open.mine").isEmpty());
    }

    @Test
    void theListsOfLessonsAndTermsAreNamed() throws Exception {
        LessonList list = list(library);
        assertEquals(List.of(), ComponentNames.unnamed(list));
        press(list, "lessons.open.twelve-keys");
        press(list, "lessons.sheet.twelve-keys");
        assertEquals("twelve-keys", done.get(0));
        assertTrue(done.get(1).contains("697, 770, 852, 941"), done.get(1));
        assertEquals(List.of(), ComponentNames.unnamed(new SheetPanel(done.get(1), "Sheet")));
        assertEquals(List.of(), ComponentNames.unnamed(new GlossaryList(Locale.forLanguageTag("es"))));
    }

    @ParameterizedTest
    @CsvSource({"en, keys", "es, teclas"})
    void theListSaysInWholeLinesWhatEachLessonIsAbout(String language, String word) throws Exception {
        LessonList list = new LessonList(library, Locale.forLanguageTag(language), false, null);
        list.setSize(600, 400);
        for (int i = 0; i < 4; i++) {
            SwingUtilities.invokeAndWait(() -> lay(list));
        }
        for (String name : library.names()) {
            assertTrue(ComponentNames.find(list, "lessons.sheet." + name).isEmpty(), "a pupil's window has no sheet");
            GlossaryText row = (GlossaryText)
                    ComponentNames.find(list, "lessons.about." + name).orElseThrow();
            assertTrue(row.getText().endsWith("."), row.getText());
            assertTrue(row.getHeight() >= row.getPreferredSize().height, name);
        }
        GlossaryText row = (GlossaryText)
                ComponentNames.find(list, "lessons.about.break-it").orElseThrow();
        assertTrue(row.getText().contains(word), row.getText());
    }

    @Test
    void aButtonKeepsItsHeightBesideALongLine() throws Exception {
        LessonList list = list(library);
        list.setSize(400, 400);
        for (int i = 0; i < 4; i++) {
            SwingUtilities.invokeAndWait(() -> lay(list));
        }
        for (String name : library.names()) {
            Component button = ComponentNames.find(list, "lessons.open." + name).orElseThrow();
            assertEquals(button.getPreferredSize().height, button.getHeight(), name);
        }
    }

    private static void lay(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                lay(inner);
            }
        }
    }

    @Test
    void theListTakesTheBackgroundOfANewThemeAndItsTitlesAreBold() {
        LessonList list = list(library);
        Theme.install(Appearance.DARK);
        SwingUtilities.updateComponentTreeUI(list);
        assertEquals(Theme.color(Ink.SURFACE), list.getBackground());
        JEditorPane title = (JEditorPane) ComponentNames.find(
                        list(library), "lessons.title." + library.names().get(0))
                .orElseThrow();
        assertTrue(StyleConstants.isBold(((StyledDocument) title.getDocument())
                .getCharacterElement(title.getDocument().getLength() / 2)
                .getAttributes()));
    }
}
