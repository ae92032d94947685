package simrobot.source.child;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/** Takes whole lines of what is printed. */
public final class ProcessOutput extends ByteArrayOutputStream {
    private static final int LONGEST = 2000;

    private final Consumer<String> lines;

    private ProcessOutput(Consumer<String> lines) {
        this.lines = lines;
    }

    /** Returns a print stream. @param lines receives one or several lines, each with its end */
    public static PrintStream of(Consumer<String> lines) {
        return new PrintStream(new ProcessOutput(lines), true, StandardCharsets.UTF_8);
    }

    @Override
    public synchronized void write(byte[] octets, int from, int length) {
        super.write(octets, from, length);
        if (count > LONGEST) {
            flush();
        }
    }

    /** A print stream flushes after each of its calls; the beginning of a line waits for its end. */
    @Override
    public synchronized void flush() {
        if (count > 0 && (buf[count - 1] == '\n' || count > LONGEST)) {
            String text = toString(StandardCharsets.UTF_8);
            reset();
            lines.accept(text);
        }
    }
}
