package simgsm.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The folders of the lessons: complete, and the same in both languages. */
class LessonLibraryTest {
    private static final List<Locale> LANGUAGES = List.of(Locale.ENGLISH, Locale.forLanguageTag("es"));
    private static final LessonLibrary SUITE = LessonLibrary.ofSuite();

    static Stream<String> names() {
        return SUITE.names().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyLessonHasItsTextsInBothLanguagesAndTwoSolutions(String name) throws Exception {
        Lesson lesson = SUITE.lesson(name);
        Set<String> keys = null;
        for (Locale language : LANGUAGES) {
            Set<String> found = SUITE.texts(lesson, language).keys();
            assertEquals(keys == null ? found : keys, found);
            keys = found;
        }
        assertFalse(SUITE.text(name, "right.txt").isBlank());
        assertFalse(SUITE.text(name, "wrong.txt").isBlank());
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyLessonHasATeachersSheetInBothLanguagesWithItsStepsInTheirOrder(String name) throws Exception {
        List<String> steps =
                SUITE.lesson(name).steps().stream().map(LessonStep::name).toList();
        for (Locale language : LANGUAGES) {
            String sheet = SUITE.sheet(name, language).orElseThrow();
            assertTrue(
                    sheet.startsWith(
                            "# " + SUITE.texts(SUITE.lesson(name), language).of("title")),
                    sheet);
            assertTrue(sheet.contains(
                    language.getLanguage().equals("es") ? "la hoja del profesor" : "the teacher's sheet"));
            List<String> named = Pattern.compile("(?m)^\\| `([^`]+)` \\|")
                    .matcher(sheet)
                    .results()
                    .map(found -> found.group(1))
                    .toList();
            assertEquals(steps, named, name + " " + language);
        }
    }

    @Test
    void anUnknownLessonIsRefusedWithTheNamesThatThereAre() {
        String text = assertThrows(LessonException.class, () -> SUITE.lesson("nothing"))
                .getMessage();
        assertTrue(text.contains("twelve-keys") && text.endsWith("found nothing"), text);
    }

    private static Path own(Path folder, String name, String lesson, String texts) throws Exception {
        Path place = Files.createDirectories(folder.resolve(name));
        Files.writeString(place.resolve("lesson.txt"), lesson);
        Files.writeString(place.resolve("en.txt"), texts);
        return place;
    }

    private static final String OWN =
            "minutes 5\r\nprogram phone simgsm-phone --number 5550100\r\nstep on\r\nwhen phone registered\r\n";
    private static final String TEXTS =
            "\uFEFFtitle: Mine\ntask: Look.\npredict: What?\nquestion: Why?\nstep on: It is on\nhint on: Wait\n";

    @Test
    void aTeachersOwnLessonsStandBehindThoseOfTheSuite(@TempDir Path folder) throws Exception {
        own(folder, "beta", OWN, TEXTS);
        own(folder, "alpha", OWN, TEXTS);
        Files.createDirectories(folder.resolve("worlds"));
        LessonLibrary library = LessonLibrary.with(folder);
        List<String> names = library.names();
        assertEquals(SUITE.names(), names.subList(0, names.size() - 2));
        assertEquals(List.of("alpha", "beta"), names.subList(names.size() - 2, names.size()));
        assertEquals(5, library.lesson("beta").minutes());
        assertEquals(
                "Mine",
                library.texts(library.lesson("beta"), Locale.forLanguageTag("es"))
                        .of("title"));
        assertEquals(Optional.empty(), library.sheet("beta", Locale.ENGLISH));
        Files.writeString(folder.resolve("beta/es.md"), "# Mía");
        assertEquals("# Mía", library.sheet("beta", Locale.ENGLISH).orElseThrow());
        Files.writeString(folder.resolve("index.txt"), "beta\n");
        names = LessonLibrary.with(folder).names();
        assertEquals("beta", names.get(names.size() - 2));
    }

    @Test
    void whatIsWrongInATeachersFolderIsSaid(@TempDir Path folder) throws Exception {
        assertFails("expected a folder for each lesson with lesson.txt, found none", () -> LessonLibrary.with(folder));
        assertFails("expected a folder that can be read", () -> LessonLibrary.with(folder.resolve("x")));
        Path mine = own(folder, "mine", OWN, TEXTS);
        assertFails("expected a folder with a folder for each lesson", () -> LessonLibrary.with(mine));
        LessonLibrary library = LessonLibrary.with(folder);
        Files.write(mine.resolve("lesson.txt"), new byte[] {'m', (byte) 0xF1});
        assertFails(mine.resolve("lesson.txt") + ": octet 2: expected UTF-8, found F1", () -> library.lesson("mine"));
        own(folder, "mine", "step a\nwhen phone\n", TEXTS);
        assertFails(
                mine.resolve("lesson.txt") + ", line 2: expected SOURCE EVENT [FIELD=VALUE]..., found phone",
                () -> library.lesson("mine"));
        own(folder, "mine", OWN, TEXTS.replace("hint on", "hint off"));
        Lesson lesson = library.lesson("mine");
        assertFails(
                mine.resolve("en.txt") + ", line 6: expected a key of title, task, predict, question, step on, hint on;"
                        + " found hint off",
                () -> library.texts(lesson, Locale.ENGLISH));
        own(folder, "mine", OWN + "#".repeat(1 << 20), TEXTS);
        assertFails(
                mine.resolve("lesson.txt") + ": expected at most 1048576 octets, found 10",
                () -> library.lesson("mine"));
        Files.write(mine.resolve("big.wav"), new byte[1 << 21]);
        assertFails("big.wav: expected at most 1048576 octets, found 2097152", () -> library.octets("mine", "big.wav"));
        Files.writeString(folder.resolve("index.txt"), "mine mine");
        assertFails("index.txt: expected each name once, found mine", () -> LessonLibrary.with(folder));
        Files.delete(folder.resolve("index.txt"));
        own(folder, "mine", OWN, TEXTS.replace("hint on: Wait\n", ""));
        assertFails(mine.resolve("en.txt") + ": expected hint on: text", () -> library.texts(lesson, Locale.ENGLISH));
        own(folder, "mine", OWN, TEXTS.replace("Look.", "Press {k}."));
        assertFails(
                mine.resolve("en.txt") + ", line 2: task: expected in braces one of folder, lesson; found k",
                () -> library.texts(lesson, Locale.ENGLISH));
        Files.writeString(folder.resolve("index.txt"), "mein\n");
        assertFails("index.txt: expected names of mine, found mein", () -> LessonLibrary.with(folder));
        own(folder, "twelve-keys", OWN, TEXTS);
        assertFails("expected another name; the suite has a lesson of this one", () -> LessonLibrary.with(folder));
    }

    private static void assertFails(String expected, Executable act) {
        String text = assertThrows(LessonException.class, act).getMessage();
        assertTrue(text.contains(expected), text);
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
