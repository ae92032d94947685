package simgsm.console;

/** The exit statuses of all programs; 69 and 74 are from sysexits. */
public final class ExitStatus {
    public static final int OK = 0;
    /** The run failed: a wait timed out, a file was no audio, a demo went wrong. */
    public static final int FAILED = 1;

    public static final int USAGE = 2;
    /** No display and no {@code --headless}, or no centre. */
    public static final int UNAVAILABLE = 69;

    public static final int INPUT_OUTPUT = 74;

    private ExitStatus() {}
}
