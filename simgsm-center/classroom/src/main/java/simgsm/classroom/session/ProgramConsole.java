package simgsm.classroom.session;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import simgsm.thread.DaemonThread;

/** The console of a started program: writes commands; its own thread reads the printed lines. */
public final class ProgramConsole {
    /** Receives the output; called on the console's thread. */
    public interface Listener {
        void line(String line);

        /** The output has ended. */
        void ended();
    }

    private final Process process;
    private final Writer commands;
    private final Listener listener;

    /** @param name of the program, for the thread */
    public ProgramConsole(String name, Process process, Listener listener) {
        this.process = process;
        this.commands = process.outputWriter(StandardCharsets.UTF_8);
        this.listener = listener;
        DaemonThread.start("console of " + name, this::read);
    }

    public Process process() {
        return process;
    }

    /** @throws IOException if the program has ended */
    public synchronized void command(String line) throws IOException {
        commands.write(line + "\n");
        commands.flush();
    }

    /** Ends the standard input. */
    public void close() throws IOException {
        process.getOutputStream().close();
    }

    private void read() {
        try (BufferedReader lines = process.inputReader(StandardCharsets.UTF_8)) {
            lines.lines().forEach(listener::line);
        } catch (IOException | java.io.UncheckedIOException e) {
            listener.line("error text=\"output broke: "
                    + String.valueOf(e.getMessage()).replace('"', '\'') + "\"");
        }
        listener.ended();
    }
}
