package simgsm.lesson;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The lessons that the programs bring along: a folder of text files each. */
public final class LessonLibrary {
    private static final String PLACE = "/lessons/";

    private LessonLibrary() {}

    /** Their names, in the order in which a class takes them. */
    public static List<String> names() {
        return LessonReader.list(file("index.txt").orElse(""));
    }

    /** @throws LessonException if there is no such lesson, naming those that there are */
    public static Lesson lesson(String name) throws LessonException {
        if (!names().contains(name)) {
            throw new LessonException("expected one of " + String.join(", ", names()) + ", found " + name);
        }
        return LessonReader.read(name, text(name, "lesson.txt"));
    }

    public static LessonTexts texts(String name, Locale language) throws LessonException {
        String file = language.getLanguage().equals("es") ? "es.txt" : "en.txt";
        return LessonTexts.read(name + "/" + file, text(name, file));
    }

    /** A file of a lesson's folder. */
    public static String text(String name, String file) throws LessonException {
        return file(name + "/" + file).orElseThrow(() -> new LessonException(name + "/" + file + ": no such file"));
    }

    /** A file of a lesson's folder, or nothing. */
    public static Optional<String> find(String name, String file) {
        return file(name + "/" + file);
    }

    static String glossary(Locale language) throws LessonException {
        return text("glossary", language.getLanguage().equals("es") ? "es.txt" : "en.txt");
    }

    private static Optional<String> file(String path) {
        try (InputStream in = LessonLibrary.class.getResourceAsStream(PLACE + path)) {
            return in == null
                    ? Optional.empty()
                    : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
