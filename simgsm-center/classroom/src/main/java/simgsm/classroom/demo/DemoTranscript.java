package simgsm.classroom.demo;

import java.io.PrintStream;
import java.util.Locale;
import simgsm.classroom.session.Consoles;

/** Prints the lines of a demo: seconds, program, event. Any thread may print. */
class DemoTranscript implements Consoles.Listener {
    private static final double NANOS_PER_SECOND = 1e9;

    private final PrintStream out;
    private final long startNanos = System.nanoTime();

    DemoTranscript(PrintStream out) {
        this.out = out;
    }

    synchronized void heading(String text) {
        out.print("\n== " + text + "\n");
        out.flush();
    }

    @Override
    public synchronized void line(String who, String what) {
        double seconds = (System.nanoTime() - startNanos) / NANOS_PER_SECOND;
        out.print(String.format(Locale.ROOT, "%8.3f  %-7s %s%n", seconds, who, what));
        out.flush();
    }
}
