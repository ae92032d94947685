package simgsm.console;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Standard output as UTF-8 whatever the locale. It knows whether and why something could not be written. */
final class StandardOutput extends PrintStream {
    /** One for the process, so that nothing which is lost goes unnoticed. */
    static final StandardOutput STREAM = new StandardOutput(new FileOutputStream(FileDescriptor.out));

    private final Sink sink;

    StandardOutput(OutputStream out) {
        this(new Sink(out));
    }

    private StandardOutput(Sink sink) {
        super(sink, false, StandardCharsets.UTF_8);
        this.sink = sink;
    }

    /** The first error of a stream, in words for a user: empty where its reader has gone away. */
    static Optional<String> failure(PrintStream out) {
        if (!out.checkError()) {
            return Optional.empty();
        }
        String reason = out instanceof StandardOutput standard && standard.sink.failure != null
                ? String.valueOf(standard.sink.failure.getMessage())
                : "cannot be written";
        boolean isReaderGone = reason.contains("Broken pipe") || reason.contains("pipe is being closed");
        return Optional.of(isReaderGone ? "" : "standard output: " + reason);
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
