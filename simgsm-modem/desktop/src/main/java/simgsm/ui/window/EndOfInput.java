package simgsm.ui.window;

import java.io.IOException;
import java.io.OutputStream;
import simgsm.thread.DaemonThread;

/** The end of standard input, held open by the program that started this one. */
final class EndOfInput {
    private EndOfInput() {}

    /** Performs the act on its own thread when the input has ended or failed. */
    static void then(Runnable act) {
        DaemonThread.start("end of input", () -> {
            try {
                System.in.transferTo(OutputStream.nullOutputStream());
            } catch (IOException e) {
                // a failed input has ended, too
            }
            act.run();
        });
    }
}
