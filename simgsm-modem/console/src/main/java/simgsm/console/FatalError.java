package simgsm.console;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;

/** Ends a program in which a necessary thread has failed, instead of leaving it hanging. */
public final class FatalError {
    /** Time-out for the shutdown hooks, such as detaching from the network. */
    private static final long SHUTDOWN_SECONDS = 5;

    /** Made beforehand, for use without memory. */
    private static final byte[] OUT_OF_MEMORY =
            ("ended: out of memory (java.lang.OutOfMemoryError); -Xmx gives the Java" + " heap more"
                            + System.lineSeparator())
                    .getBytes(StandardCharsets.US_ASCII);

    private static final FileOutputStream STANDARD_ERROR = new FileOutputStream(FileDescriptor.err);

    /** Errors after the end has begun are from closed parts. */
    private static volatile boolean isEnding;

    private FatalError() {}

    /**
     * Ends the program if a thread dies of an error of the Java machine, such as {@link OutOfMemoryError}; other
     * exceptions of threads are printed as by default.
     *
     * @param program as in its messages
     */
    public static void endOnMachineErrors(String program) {
        Thread.setDefaultUncaughtExceptionHandler((thread, cause) -> {
            if (cause instanceof VirtualMachineError) {
                end(program, cause);
            } else {
                System.err.print("Exception in thread \"" + thread.getName() + "\" ");
                cause.printStackTrace();
            }
        });
    }

    /**
     * Prints the cause on standard error and ends the process with {@link ExitStatus#FAILED}. Returns at once, because the
     * exit may wait for the calling thread.
     *
     * @param program as in its messages, such as {@code simgsm-phone}
     */
    public static void end(String program, Throwable cause) {
        if (isEnding) {
            return;
        }
        try {
            if (cause instanceof OutOfMemoryError) {
                STANDARD_ERROR.write(OUT_OF_MEMORY);
            } else {
                System.err.println(sentence(program, cause));
            }
            exit(ExitStatus.FAILED);
        } catch (Throwable hopeless) {
            // Usually out of memory for a thread.
            Runtime.getRuntime().halt(ExitStatus.FAILED);
        }
    }

    /** Ends the process in order, or after 5 s without its shutdown hooks. Returns at once. */
    static void exit(int status) {
        isEnding = true;
        Thread halt = new Thread(() -> haltSoon(status), "halt");
        halt.setDaemon(true);
        halt.start();
        new Thread(() -> System.exit(status), "exit").start();
    }

    static String sentence(String program, Throwable cause) {
        return program + ": ended by an error of its own: " + cause;
    }

    private static void haltSoon(int status) {
        try {
            TimeUnit.SECONDS.sleep(SHUTDOWN_SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        Runtime.getRuntime().halt(status);
    }
}
