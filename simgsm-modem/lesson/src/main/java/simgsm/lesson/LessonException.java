package simgsm.lesson;

/** A lesson, or a solution of one, that cannot be read; the text names file, line and expected form. */
public final class LessonException extends Exception {
    public LessonException(String text) {
        super(text);
    }
}
