package simgsm.thread;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class DaemonThreadTest {
    @Test
    void anInterruptEndsTheWork() throws InterruptedException {
        Thread waiting = DaemonThread.start("waiting", new CountDownLatch(1)::await);
        assertTrue(waiting.isDaemon());
        assertEquals("waiting", waiting.getName());

        waiting.interrupt();
        waiting.join(TimeUnit.MINUTES.toMillis(1));
        assertFalse(waiting.isAlive());
    }

    @Test
    void anExecutorKeepsTheOrder() throws InterruptedException {
        List<String> ran = new CopyOnWriteArrayList<>();
        ExecutorService executor = DaemonThread.executor("work");
        executor.execute(() -> ran.add(Thread.currentThread().getName()));
        executor.execute(() -> ran.add("second"));
        executor.shutdown();

        assertTrue(executor.awaitTermination(1, TimeUnit.MINUTES));
        assertEquals(List.of("work", "second"), ran);
    }
}
