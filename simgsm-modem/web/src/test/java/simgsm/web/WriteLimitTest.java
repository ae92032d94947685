package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class WriteLimitTest {
    /** A client that reads nothing: a write lasts until it is interrupted. */
    private static final class Stuck extends OutputStream {
        @Override
        public void write(int octet) throws IOException {
            try {
                new CountDownLatch(1).await();
            } catch (InterruptedException e) {
                throw new InterruptedIOException("interrupted");
            }
        }
    }

    @Test
    void aWriteThatTheClientDoesNotTakeIsInterrupted() throws Exception {
        try (WriteLimit limit = new WriteLimit(1)) {
            limit.start();
            OutputStream output = limit.limited(new Stuck());
            assertThrows(InterruptedIOException.class, () -> output.write(new byte[100]));
            assertThrows(InterruptedIOException.class, () -> output.write(1));
        }
    }

    /** So a client that reads slowly keeps its answer: each part has the whole limit. */
    @Test
    void aLargeAnswerIsWrittenInPartsOf8KiB() throws Exception {
        byte[] answer = new byte[20_000];
        new Random(1).nextBytes(answer);
        List<Integer> parts = new ArrayList<>();
        ByteArrayOutputStream all = new ByteArrayOutputStream() {
            @Override
            public synchronized void write(byte[] octets, int offset, int length) {
                parts.add(length);
                super.write(octets, offset, length);
            }
        };
        try (WriteLimit limit = new WriteLimit(Long.MAX_VALUE);
                OutputStream output = limit.limited(all)) {
            output.write(answer);
        }
        assertEquals(List.of(8_192, 8_192, 3_616), parts);
        assertArrayEquals(answer, all.toByteArray());
        assertFalse(Thread.currentThread().isInterrupted());
    }
}
