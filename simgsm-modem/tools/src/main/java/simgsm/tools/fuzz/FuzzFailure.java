package simgsm.tools.fuzz;

/** A fault found by fuzzing; the text names it and the frame. */
public final class FuzzFailure extends RuntimeException {
    private static final long serialVersionUID = 1;

    FuzzFailure(String text, Throwable cause) {
        super(text, cause);
    }
}
