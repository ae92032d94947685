package simrobot.source;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import simgsm.thread.DaemonThread;

/** One operating system process on a pipe, with a thread for each direction: neither side waits for the other. */
final class ChildProcess {
    private static final int MAX_LINE = 20_000;

    /** Learns what the process says; called on its reading thread. */
    interface Listener {
        /** @param line its first 20 000 characters */
        void heard(ChildProcess from, String line);

        /** The process has ended, and all its lines were heard. */
        void ended(ChildProcess from, int status);
    }

    private final Process process;
    private final Listener listener;
    private StringBuilder outgoing = new StringBuilder();

    /** @throws IOException if the program cannot be started */
    ChildProcess(String name, List<String> command, Listener listener) throws IOException {
        this.listener = listener;
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        // its options are for SimRobot, and Java would print them first
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        process = start(builder);
        DaemonThread.start("to behaviour " + name, this::write);
        DaemonThread.start("from behaviour " + name, this::read);
    }

    private static Process start(ProcessBuilder builder) throws IOException {
        try {
            return builder.start();
        } catch (IOException e) {
            throw new IOException(
                    "cannot be started: expected the program "
                            + builder.command().get(0),
                    e);
        }
    }

    /** Queues a line until {@link #flush}; never waits. */
    synchronized void send(String line) {
        outgoing.append(line).append('\n');
    }

    synchronized void flush() {
        notifyAll();
    }

    /** Ends the process and those that it has started. */
    void kill() {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
    }

    private void write() {
        try (OutputStream out = process.getOutputStream()) {
            while (process.isAlive()) {
                out.write(next().getBytes(StandardCharsets.UTF_8));
                out.flush();
            }
        } catch (IOException | InterruptedException e) {
            // it reads no more: its end is told by the reading thread
            kill();
        }
    }

    private synchronized String next() throws InterruptedException {
        while (outgoing.isEmpty()) {
            wait();
        }
        String lines = outgoing.toString();
        outgoing = new StringBuilder();
        return lines;
    }

    private void read() {
        try (Reader in =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8), 1 << 16)) {
            StringBuilder line = new StringBuilder();
            for (int next = in.read(); next >= 0; next = in.read()) {
                if (next == '\n') {
                    listener.heard(this, line.toString());
                    line.setLength(0);
                } else if (line.length() < MAX_LINE && next != '\r') {
                    line.append((char) next);
                }
            }
            listener.ended(this, process.waitFor());
        } catch (IOException | InterruptedException e) {
            kill();
            listener.ended(this, 0);
        } finally {
            send("");
            flush();
        }
    }
}
