package simrobot.source;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import simrobot.behaviour.Requests;

/** A {@code System.out} that notes what processes print, and passes on what others do. */
public final class ProcessOutput extends ByteArrayOutputStream {
    private final PrintStream others;

    private ProcessOutput(PrintStream others) {
        this.others = others;
    }

    /** Puts it in place of {@code System.out}, for the whole program. @param others receives what no process prints */
    public static void install(PrintStream others) {
        System.setOut(new PrintStream(new ProcessOutput(others), true, StandardCharsets.UTF_8));
    }

    /** A print stream writes whole characters before it flushes. */
    @Override
    public synchronized void flush() {
        String text = toString(StandardCharsets.UTF_8);
        reset();
        if (!Requests.notePrinted(text)) {
            others.print(text);
        }
    }
}
