package simgsm.tools.fuzz;

/** Something that must not happen has happened; the text says what, and to which frame. */
public final class Finding extends RuntimeException {
    private static final long serialVersionUID = 1;

    Finding(String text, Throwable cause) {
        super(text, cause);
    }
}
