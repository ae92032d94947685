package simgsm.classroom.lesson;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simgsm.classroom.session.SessionFailure;
import simgsm.file.Utf8Text;
import simgsm.lesson.LessonException;
import simgsm.lesson.LessonLibrary;

/**
 * A solution to play: lines of a file, or one of the lesson's two built-in solutions. {@code use FILE} hands in a file
 * from the same folder.
 *
 * @param isOwn true for a built-in solution, which may use the values that students have to find
 */
record Solution(
        String name, List<String> lines, boolean isOwn, Optional<Path> file, LessonLibrary library, String lesson) {
    /** @throws IOException if a student's file cannot be read */
    static Solution of(LessonLibrary library, String lesson, String named) throws LessonException, IOException {
        if (named.equals("right") || named.equals("wrong")) {
            String text = library.text(lesson, named + ".txt");
            return new Solution(named, text.lines().toList(), true, Optional.empty(), library, lesson);
        }
        Path file = Path.of(named);
        return new Solution(
                named,
                Utf8Text.read(file).lines().toList(),
                false,
                Optional.of(file.toAbsolutePath()),
                library,
                lesson);
    }

    /** Reads a file of the solution's folder. */
    private byte[] beside(String other) throws LessonException, IOException {
        return file.isPresent()
                ? Files.readAllBytes(file.get().resolveSibling(other))
                : library.octets(lesson, name + "/" + other);
    }

    /**
     * Performs all lines.
     *
     * @throws SessionFailure naming the line that failed
     */
    void play(LessonSession session) throws SessionFailure, InterruptedException {
        int number = 0;
        for (String line : lines) {
            number++;
            if (!line.isBlank() && !line.startsWith("#")) {
                try {
                    perform(line.strip(), session);
                } catch (SessionFailure e) {
                    throw new SessionFailure(name + ", line " + number + ": " + e.getMessage());
                }
            }
        }
    }

    private void perform(String line, LessonSession session) throws SessionFailure, InterruptedException {
        String text = session.replaced(line, isOwn);
        if (!text.startsWith("use ")) {
            session.perform(text);
            return;
        }
        String wanted = text.substring("use ".length()).strip();
        try {
            Path file = Path.of(wanted);
            if (!file.equals(file.getFileName()) || wanted.equals("..")) {
                throw new SessionFailure("use: expected the name of a file beside the solution, found " + wanted);
            }
            byte[] content = beside(wanted);
            session.handIn(
                    wanted,
                    isOwn ? session.replaced(new String(content, UTF_8), true).getBytes(UTF_8) : content);
        } catch (IOException | LessonException | IllegalArgumentException e) {
            throw new SessionFailure("use: " + e.getMessage());
        }
    }
}
