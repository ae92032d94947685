package simgsm.center.app;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import simgsm.console.CommandException;
import simgsm.console.Event;

/** The console of a child process: commands go in, lines and events come out on a thread of its own. */
public final class ChildConsole {
    /** What comes out; called on the console's thread. */
    public interface Listener {
        /** A printed line, before its event; or what was wrong with the output. */
        void line(String line);

        void event(Event event);

        /** The output has ended. */
        void ended();
    }

    private final Process process;
    private final OutputStream commands;
    private final Listener listener;

    /** @param name of the program, for the thread */
    public ChildConsole(String name, Process process, Listener listener) {
        this.process = process;
        this.commands = process.getOutputStream();
        this.listener = listener;
        Thread reader = new Thread(this::read, "console of " + name);
        reader.setDaemon(true);
        reader.start();
    }

    public Process process() {
        return process;
    }

    /** @throws IOException if the program has ended */
    public void command(String line) throws IOException {
        commands.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        commands.flush();
    }

    private void read() {
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                listener.line(line);
                event(line);
            }
        } catch (IOException e) {
            listener.line("its output broke off: " + e.getMessage());
        }
        listener.ended();
    }

    private void event(String line) {
        Event event;
        try {
            event = Event.parse(line);
        } catch (CommandException e) {
            listener.line("that line is no event: " + e.getMessage());
            return;
        }
        listener.event(event);
    }
}
