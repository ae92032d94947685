package simgsm.classroom.lesson;

/** A line of a solution or of a lesson that could not be performed; the text says what was expected. */
public final class LessonFailure extends Exception {
    LessonFailure(String text) {
        super(text);
    }
}
