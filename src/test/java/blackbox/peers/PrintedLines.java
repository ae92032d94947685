package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** The lines that a running peer prints on its standard output. */
final class PrintedLines {
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(120);

    private final List<String> lines = new ArrayList<>();
    private boolean isEnded;

    PrintedLines(Process peer) {
        Thread reader = new Thread(() -> read(peer), "lines of a peer");
        reader.setDaemon(true);
        reader.start();
    }

    private void read(Process peer) {
        try (BufferedReader in =
                new BufferedReader(new InputStreamReader(peer.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                add(line);
            }
        } catch (IOException e) {
            add("its output is closed: " + e.getMessage());
        }
        end();
    }

    private synchronized void add(String line) {
        lines.add(line);
        notifyAll();
    }

    private synchronized void end() {
        isEnded = true;
        notifyAll();
    }

    /** The lines that begin with this word. */
    synchronized List<String> of(String word) {
        return lines.stream()
                .filter(line -> line.equals(word) || line.startsWith(word + " "))
                .toList();
    }

    /** Waits until the lines so far fulfil a condition; fails after 120 s, or if the peer ends before. */
    synchronized void await(Predicate<List<String>> condition, String text) throws InterruptedException {
        long deadline = System.nanoTime() + PATIENCE_NANOS;
        while (!condition.test(lines)) {
            long left = deadline - System.nanoTime();
            assertTrue(left > 0 && !isEnded, () -> "not printed: " + text + "\n" + String.join("\n", lines));
            TimeUnit.NANOSECONDS.timedWait(this, left);
        }
    }

    /** Waits for a line that begins with this text. */
    void await(String start) throws InterruptedException {
        await(all -> all.stream().anyMatch(line -> line.startsWith(start)), start);
    }
}
