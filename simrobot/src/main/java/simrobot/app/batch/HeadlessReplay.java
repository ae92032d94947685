package simrobot.app.batch;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.OptionalDouble;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simrobot.replay.RecordedEvent;
import simrobot.replay.Recording;

/**
 * {@code --replay FILE --headless}: prints the events of a recorded session as the console did, at a pace or without
 * pauses.
 */
public final class HeadlessReplay {
    private final PrintStream out;
    private final PrintStream log;
    private final OptionalDouble speed;
    private long beganNanos;

    /** @param speed simulated seconds per second; empty for no pauses */
    public HeadlessReplay(PrintStream out, PrintStream log, OptionalDouble speed) {
        this.out = out;
        this.log = log;
        this.speed = speed;
    }

    /**
     * Plays the whole recording.
     *
     * @throws IOException if it cannot be read, or, after the valid events, if it is damaged
     */
    public int play(Path file) throws IOException, InterruptedException {
        try (Recording recording = Recording.open(file)) {
            beganNanos = System.nanoTime();
            print(Event.of("ready")
                    .with("robots", String.join(",", recording.robots()))
                    .toString());
            for (RecordedEvent event : recording.events()) {
                await(event.timeNanos() - recording.firstNanos());
                print(event.line());
            }
            await(recording.lastNanos() - recording.firstNanos());
            if (recording.damage().isPresent()) {
                throw new IOException(recording.damage().get());
            }
            if (recording.isTorn()) {
                log.println("simrobot: " + file + ": the end is missing; what was recorded before is whole");
            }
            return ExitStatus.OK;
        }
    }

    private void print(String line) {
        out.print(line + "\n");
        out.flush();
    }

    private void await(long simulatedNanos) throws InterruptedException {
        if (speed.isPresent()) {
            double dueNanos = simulatedNanos / speed.getAsDouble() - (System.nanoTime() - beganNanos);
            if (dueNanos > 0) {
                Thread.sleep((long) (dueNanos / 1e6));
            }
        }
    }
}
