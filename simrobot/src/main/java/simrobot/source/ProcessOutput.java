package simrobot.source;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import simrobot.behaviour.Answer;
import simrobot.behaviour.Request;

/** A {@code System.out} that notes the lines which processes print, and passes on what others do. */
public final class ProcessOutput extends ByteArrayOutputStream {
    private final PrintStream others;

    private ProcessOutput(PrintStream others) {
        this.others = others;
    }

    /**
     * Replaces {@code System.out} for the whole program.
     *
     * @param others receives output that no process prints
     */
    public static void install(PrintStream others) {
        System.setOut(new PrintStream(new ProcessOutput(others), true, StandardCharsets.UTF_8));
    }

    /** A print stream flushes after each of its calls; the beginning of a line waits for its end. */
    @Override
    public synchronized void flush() {
        if (!Answer.isOpen()) {
            others.print(toString(StandardCharsets.UTF_8));
            reset();
        } else if (count > 0 && buf[count - 1] == '\n') {
            String lines = toString(StandardCharsets.UTF_8);
            reset();
            Answer.ask(new Request.Printed(lines));
        }
    }
}
