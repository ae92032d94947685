package simgsm.thread;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Threads that do not keep the process from ending. */
public final class DaemonThread {
    /** The work of a thread, which returns or throws when it is interrupted. */
    public interface Work {
        void run() throws InterruptedException;
    }

    private DaemonThread() {}

    /** A thread that is not started. */
    public static Thread of(String name, Work work) {
        Runnable interruptible = () -> {
            try {
                work.run();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        };
        Thread thread = new Thread(interruptible, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Starts a thread. */
    public static Thread start(String name, Work work) {
        Thread thread = of(name, work);
        thread.start();
        return thread;
    }

    /** Waits for the end of a thread, at most this time (0: without a limit) and not after an interrupt. */
    public static void join(Thread thread, long millis) {
        try {
            thread.join(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Runs actions in their order on one thread. */
    public static ExecutorService executor(String name) {
        return Executors.newSingleThreadExecutor(work -> of(name, work::run));
    }
}
