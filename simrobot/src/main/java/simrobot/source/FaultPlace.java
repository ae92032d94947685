package simrobot.source;

import java.util.Arrays;
import java.util.Objects;

/** Finds the line of a student's source in a stack trace. @param file name of the source file; null for a jar's */
record FaultPlace(String file) {
    /** The innermost line of the source; for a jar, the innermost line outside the JDK and SimRobot. 0 if unknown. */
    int line(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(this::isStudents)
                .mapToInt(frame -> Math.max(0, frame.getLineNumber()))
                .findFirst()
                .orElse(0);
    }

    private boolean isStudents(StackTraceElement frame) {
        return file == null
                ? frame.getModuleName() == null && !frame.getClassName().startsWith("simrobot.")
                : Objects.equals(frame.getFileName(), file);
    }

    /** The exception in words: {@code ArithmeticException: / by zero}. */
    static String text(Throwable thrown) {
        String name = thrown.getClass().getSimpleName();
        return thrown.getMessage() == null ? name : name + ": " + thrown.getMessage();
    }
}
