package simrobot.app;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Assumptions;

/** A file whose disk takes the first octets and refuses what is written after {@link #breakOff}: a pipe without a reader. */
public final class BrokenPipe implements AutoCloseable {
    private final Path path;
    private final CountDownLatch broken = new CountDownLatch(1);
    private final Thread reader = new Thread(this::read, "reader");

    public BrokenPipe(Path path) throws InterruptedException {
        this.path = path;
        Assumptions.assumeTrue(isMade(), "no mkfifo");
        reader.setDaemon(true);
        reader.start();
    }

    private boolean isMade() throws InterruptedException {
        try {
            return new ProcessBuilder("mkfifo", path.toString()).start().waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    private void read() {
        try (InputStream in = Files.newInputStream(path)) {
            in.read();
            broken.await();
        } catch (IOException e) {
            throw new AssertionError(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    public Path path() {
        return path;
    }

    /** From the first octet on nothing is taken; what waits in the pipe is lost. */
    public void breakOff() {
        broken.countDown();
    }

    @Override
    public void close() {
        breakOff();
    }
}
