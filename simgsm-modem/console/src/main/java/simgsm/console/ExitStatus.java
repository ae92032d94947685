package simgsm.console;

/** The statuses that a program of the suite ends with; the large ones are those of sysexits. */
public final class ExitStatus {
    public static final int OK = 0;
    /** The run failed: a wait timed out, a file was no audio, a demo went wrong. */
    public static final int FAILED = 1;

    public static final int USAGE = 2;
    /** What is needed is not there: no display and no {@code --headless}, or no centre. */
    public static final int UNAVAILABLE = 69;

    public static final int INPUT_OUTPUT = 74;

    private ExitStatus() {}
}
