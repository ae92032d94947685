package simgsm.ui.window;

import java.io.IOException;
import java.io.OutputStream;

/** The end of standard input, which the program that started this one holds open. */
final class EndOfInput {
    private EndOfInput() {}

    /** Performs the act on a thread of its own when the input has ended, or was broken. */
    static void then(Runnable act) {
        Thread reader = new Thread(
                () -> {
                    try {
                        System.in.transferTo(OutputStream.nullOutputStream());
                    } catch (IOException e) {
                        // a broken input has ended, too
                    }
                    act.run();
                },
                "end of input");
        reader.setDaemon(true);
        reader.start();
    }
}
