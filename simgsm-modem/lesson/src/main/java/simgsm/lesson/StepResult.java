package simgsm.lesson;

/**
 * A step's result tells whether a student has done the step, and with how many tries and hints.
 *
 * @param tries the number of answers given to the step, or of attempts that its conditions counted
 * @param hints 1 if the step's hint was opened before the step was done, else 0
 */
public record StepResult(String lesson, String step, boolean isPassed, int tries, int hints) {
    /** {@code pass} or {@code fail}, as results have it. */
    public String word() {
        return isPassed ? "pass" : "fail";
    }
}
