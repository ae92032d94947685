package simrobot.source.child;

import java.util.Arrays;
import java.util.Objects;

/** Finds the line of a student's source in a stack trace. @param file name of the source file; null for a jar's */
public record FaultPlace(String file) {
    /** The innermost line of the source; of a jar, the innermost of its classes. 0 if there is none. */
    public int line(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(frame -> LoadedClasses.NAME.equals(frame.getClassLoaderName()))
                .filter(frame -> file == null || Objects.equals(frame.getFileName(), file))
                .mapToInt(frame -> Math.max(0, frame.getLineNumber()))
                .findFirst()
                .orElse(0);
    }

    /** The exception of a static initialiser; else the same. */
    public static Throwable cause(Throwable thrown) {
        return thrown instanceof ExceptionInInitializerError && thrown.getCause() != null ? thrown.getCause() : thrown;
    }

    /** The exception in words: {@code ArithmeticException: / by zero}. */
    public static String text(Throwable thrown) {
        String name = thrown.getClass().getSimpleName();
        return thrown.getMessage() == null ? name : name + ": " + thrown.getMessage();
    }
}
