package simgsm.lesson;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.file.FileErrors;
import simgsm.file.Utf8Text;

/** The lessons of the suite and of a teacher's folder; each is a folder of text files. */
public final class LessonLibrary {
    private static final String OPTION = "lessons";
    private static final String PLACE = "/lessons/";
    private static final String LESSON = "lesson.txt";
    private static final String INDEX = "index.txt";
    /** Limit of a lesson's file; the longest of the suite has a hundredth of it. */
    private static final long MOST_OCTETS = 1 << 20;

    private static final LessonLibrary SUITE =
            new LessonLibrary(LessonReader.list(resource(INDEX).orElse("")), Optional.empty(), List.of());

    private final List<String> suite;
    private final Optional<Path> folder;
    private final List<String> own;

    private LessonLibrary(List<String> suite, Optional<Path> folder, List<String> own) {
        this.suite = suite;
        this.folder = folder;
        this.own = own;
    }

    /** The lessons of the suite alone. */
    public static LessonLibrary ofSuite() {
        return SUITE;
    }

    /**
     * The lessons of the suite and those of {@code --lessons DIR}.
     *
     * @throws UsageException if the folder has no lessons
     */
    public static LessonLibrary of(Arguments arguments) throws UsageException {
        String given = arguments.text(OPTION).orElse("");
        try {
            return given.isEmpty() ? SUITE : with(Path.of(given));
        } catch (LessonException e) {
            throw new UsageException("--" + OPTION + ": " + e.getMessage());
        }
    }

    /**
     * The lessons of the suite and those of a teacher's folder: each subfolder with {@code lesson.txt}, in the order
     * of {@code index.txt}, or of their names.
     *
     * @throws LessonException if there are none, or one has a name of the suite's
     */
    public static LessonLibrary with(Path folder) throws LessonException {
        if (Files.isRegularFile(folder.resolve(LESSON))) {
            throw new LessonException(
                    folder + ": expected a folder with a folder for each lesson, found " + LESSON + " in it");
        }
        List<String> found = folders(folder);
        if (found.isEmpty()) {
            throw new LessonException(folder + ": expected a folder for each lesson with " + LESSON + ", found none");
        }
        for (String name : found) {
            if (SUITE.suite.contains(name)) {
                throw new LessonException(
                        folder.resolve(name) + ": expected another name; the suite has a lesson of this one");
            }
            if (!name.matches("[\\p{L}\\p{N}_-]+")) {
                throw new LessonException(
                        folder.resolve(name) + ": expected a name of letters, digits, hyphens and underscores");
            }
        }
        Path index = folder.resolve(INDEX);
        if (Files.isRegularFile(index)) {
            found = ordered(index, found);
        }
        return new LessonLibrary(SUITE.suite, Optional.of(folder), List.copyOf(found));
    }

    private static List<String> folders(Path folder) throws LessonException {
        try (Stream<Path> inside = Files.list(folder)) {
            return inside.filter(each -> Files.isRegularFile(each.resolve(LESSON)))
                    .map(each -> each.getFileName().toString())
                    .sorted()
                    .toList();
        } catch (IOException | UncheckedIOException e) {
            throw new LessonException(folder + ": expected a folder that can be read");
        }
    }

    /** The names of the index, then the other names. */
    private static List<String> ordered(Path index, List<String> found) throws LessonException {
        List<String> names = new ArrayList<>(LessonReader.list(text(index)));
        for (String name : names) {
            if (!found.contains(name)) {
                throw new LessonException(
                        index + ": expected names of " + String.join(", ", found) + ", found " + name);
            }
            if (names.indexOf(name) != names.lastIndexOf(name)) {
                throw new LessonException(index + ": expected each name once, found " + name + " for the second time");
            }
        }
        found.stream().filter(name -> !names.contains(name)).forEach(names::add);
        return names;
    }

    /** Names of the lessons in the order of a course, a teacher's own last. */
    public List<String> names() {
        return Stream.concat(suite.stream(), own.stream()).toList();
    }

    /** The folder of a teacher's own lesson; empty for a lesson of the suite. */
    public Optional<Path> folder(String name) {
        return own.contains(name) ? folder.map(each -> each.resolve(name)) : Optional.empty();
    }

    /** @throws LessonException if the lesson cannot be read, or does not exist; then naming those that do */
    public Lesson lesson(String name) throws LessonException {
        if (!names().contains(name)) {
            throw new LessonException("expected one of " + String.join(", ", names()) + ", found " + name);
        }
        return LessonReader.read(name, place(name, LESSON), text(name, LESSON));
    }

    /** False for a lesson that cannot be read, too. */
    public boolean hasStep(String lesson, String step) {
        try {
            return lesson(lesson).steps().stream().anyMatch(each -> each.name().equals(step));
        } catch (LessonException e) {
            return false;
        }
    }

    /** The texts in a language; in the other one if the lesson has only these. */
    public LessonTexts texts(Lesson lesson, Locale language) throws LessonException {
        String wanted = file(language, ".txt");
        String other = wanted.equals("es.txt") ? "en.txt" : "es.txt";
        String file = find(lesson.name(), wanted).isEmpty()
                        && find(lesson.name(), other).isPresent()
                ? other
                : wanted;
        LessonTexts texts = LessonTexts.read(place(lesson.name(), file), text(lesson.name(), file));
        texts.require(lesson);
        return texts;
    }

    /** The teacher's sheet of a lesson, in Markdown; in the other language if there is only that. */
    public Optional<String> sheet(String name, Locale language) throws LessonException {
        String wanted = file(language, ".md");
        Optional<String> sheet = sheet(name, wanted);
        return sheet.isPresent() ? sheet : sheet(name, wanted.equals("es.md") ? "en.md" : "es.md");
    }

    private Optional<String> sheet(String name, String file) throws LessonException {
        return own.contains(name) ? find(name, file) : resource("sheets/" + file.replace(".md", "/" + name + ".md"));
    }

    private static String file(Locale language, String ending) {
        return (language.getLanguage().equals("es") ? "es" : "en") + ending;
    }

    /** A file of a lesson's folder. */
    public String text(String name, String file) throws LessonException {
        return find(name, file).orElseThrow(() -> new LessonException(place(name, file) + ": no such file"));
    }

    /** A file of a lesson's folder, unchanged. */
    public byte[] octets(String name, String file) throws LessonException, IOException {
        if (own.contains(name)) {
            Path path = folder.orElseThrow().resolve(name).resolve(file);
            requireSmall(path);
            return Files.readAllBytes(path);
        }
        return text(name, file).getBytes(StandardCharsets.UTF_8);
    }

    /** The name of a lesson's file in messages. */
    private String place(String name, String file) {
        return folder(name).map(each -> each.resolve(file).toString()).orElse(name + "/" + file);
    }

    private Optional<String> find(String name, String file) throws LessonException {
        if (!own.contains(name)) {
            return resource(name + "/" + file);
        }
        Path path = folder.orElseThrow().resolve(name).resolve(file);
        return Files.isRegularFile(path) ? Optional.of(text(path)) : Optional.empty();
    }

    private static void requireSmall(Path file) throws LessonException, IOException {
        long octets = FileErrors.naming(file, () -> Files.size(file));
        if (octets > MOST_OCTETS) {
            throw new LessonException(file + ": expected at most " + MOST_OCTETS + " octets, found " + octets);
        }
    }

    /** A text file in UTF-8, from an editor of any system. */
    private static String text(Path file) throws LessonException {
        try {
            requireSmall(file);
            return Utf8Text.read(file).replace("\r\n", "\n");
        } catch (IOException e) {
            throw new LessonException(FileErrors.describe(e));
        }
    }

    private static Optional<String> resource(String path) {
        try (InputStream in = LessonLibrary.class.getResourceAsStream(PLACE + path)) {
            return in == null
                    ? Optional.empty()
                    : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
