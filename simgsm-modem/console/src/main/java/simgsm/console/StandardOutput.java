package simgsm.console;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicBoolean;

/** Standard output as UTF-8 in every locale, with the cause of a failed write. */
final class StandardOutput extends PrintStream {
    /** One per process, so that every lost line is noticed. */
    static final StandardOutput STREAM = new StandardOutput(new FileOutputStream(FileDescriptor.out));

    private final Sink sink;
    private final AtomicBoolean isReported = new AtomicBoolean();
    private volatile String program = "java";

    StandardOutput(OutputStream out) {
        this(new Sink(out));
    }

    private StandardOutput(Sink sink) {
        super(sink, false, StandardCharsets.UTF_8);
        this.sink = sink;
    }

    /** Sets the name of the writing program, for {@link #hasFailed}. */
    void setProgram(String name) {
        program = name;
    }

    /**
     * True if a write failed. The first such call prints the cause, unless the reader of the output has closed it.
     */
    boolean hasFailed(PrintStream err) {
        if (!checkError()) {
            return false;
        }
        String reason = String.valueOf(sink.failure == null ? null : sink.failure.getMessage());
        boolean isReaderGone = reason.contains("Broken pipe") || reason.contains("pipe is being closed");
        if (!isReaderGone && !isReported.getAndSet(true)) {
            err.println(program + ": standard output: " + reason);
        }
        return true;
    }

    private static final class Sink extends FilterOutputStream {
        private volatile IOException failure;

        Sink(OutputStream out) {
            super(out);
        }

        @Override
        public void write(int octet) throws IOException {
            write(new byte[] {(byte) octet}, 0, 1);
        }

        @Override
        public void write(byte[] octets, int from, int length) throws IOException {
            try {
                out.write(octets, from, length);
            } catch (IOException e) {
                failure = failure == null ? e : failure;
                throw e;
            }
        }
    }
}
