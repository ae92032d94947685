package simgsm.console;

import java.util.concurrent.TimeUnit;

/** The end of a program whose essential thread has died: it must neither look alive nor hang. */
public final class Collapse {
    /** So long may the program's parting take, such as detaching from the network. */
    private static final long PARTING_SECONDS = 5;

    private Collapse() {}

    /**
     * Says on standard error why and ends the process with {@link ExitStatus#FAILED}. Returns at once, for the exit may wait
     * for the calling thread.
     *
     * @param program as users know it, such as {@code simgsm-phone}
     */
    public static void end(String program, Throwable cause) {
        try {
            System.err.println(sentence(program, cause));
            Thread halt = new Thread(Collapse::haltSoon, "halt");
            halt.setDaemon(true);
            halt.start();
            new Thread(() -> System.exit(ExitStatus.FAILED), "exit").start();
        } catch (Throwable hopeless) {
            // Out of memory or threads, as a rule.
            Runtime.getRuntime().halt(ExitStatus.FAILED);
        }
    }

    static String sentence(String program, Throwable cause) {
        return program + ": ended by an error of its own: " + cause;
    }

    private static void haltSoon() {
        try {
            TimeUnit.SECONDS.sleep(PARTING_SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        Runtime.getRuntime().halt(ExitStatus.FAILED);
    }
}
