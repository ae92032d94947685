package simgsm.classroom.ui;

/** The student's actions in a lesson's window; called on the event thread, return at once. */
public interface LessonActions {
    void predict(String text);

    void answer(String name, String text);

    /** The student opens the hint of a step. */
    void hint(String step);

    /** Performs an action of the lesson. @param input what the student has typed or chosen */
    void act(String name, String input);

    void startProgram(String name);

    void stopProgram(String name);

    /**
     * Writes the result for the teacher.
     *
     * @param student the name on it
     */
    void save(String student);

    /** Ends this lesson and opens another one. */
    void open(String lesson);
}
