package simgsm.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The folders of the lessons: complete, and the same in both languages. */
class LessonLibraryTest {
    static Stream<String> names() {
        return LessonLibrary.names().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyLessonHasItsTextsInBothLanguagesAndTwoSolutions(String name) throws Exception {
        Lesson lesson = LessonLibrary.lesson(name);
        Set<String> keys = new TreeSet<>(Set.of("title", "task", "predict", "question"));
        lesson.steps().forEach(step -> {
            keys.add("step " + step.name());
            keys.add("hint " + step.name());
        });
        lesson.actions().forEach(action -> keys.add("action " + action.name()));
        for (String language : new String[] {"en", "es"}) {
            LessonTexts texts = LessonLibrary.texts(name, Locale.forLanguageTag(language));
            assertEquals(keys, new TreeSet<>(texts.keys()), language);
            texts.keys().forEach(key -> assertFalse(texts.of(key).isBlank(), language + " " + key));
        }
        assertFalse(LessonLibrary.text(name, "right.txt").isBlank());
        assertFalse(LessonLibrary.text(name, "wrong.txt").isBlank());
    }

    @Test
    void anUnknownLessonIsRefusedWithTheNamesThatThereAre() {
        String text = assertThrows(LessonException.class, () -> LessonLibrary.lesson("nothing"))
                .getMessage();
        assertTrue(text.contains("twelve-keys") && text.endsWith("found nothing"), text);
    }

    @Test
    void aTextGoesOnInIndentedLinesAndParagraphs() throws Exception {
        LessonTexts texts = LessonTexts.read("x", "task: One\n  two.\n\n  Three.\nhint a: four: five\n");
        assertEquals("One two.\n\nThree.", texts.of("task"));
        assertEquals("four: five", texts.of("hint a"));
        assertThrows(LessonException.class, () -> LessonTexts.read("x", "no key\n"));
        assertThrows(LessonException.class, () -> LessonTexts.read("x", "a: 1\na: 2\n"));
    }
}
