package simgsm.octets;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class OctetsTest {
    /** Calls after which the compiler of a JDK has optimised a method, several times. */
    private static final int CALLS = 400_000;

    @Test
    void aRangeIsCopiedFromItsFirstToBeforeItsLastIndex() {
        assertArrayEquals(new byte[] {2, 3}, Octets.range(new byte[] {1, 2, 3, 4}, 1, 3));
        assertArrayEquals(new byte[0], Octets.range(new byte[] {1}, 1, 1));
    }

    /** Fails on 17.0.15 if the reader cuts its octets with {@code Arrays.copyOfRange}. */
    @Test
    void fourOctetsThatAreReadAndCopiedStayTheSameInCompiledCode() throws Exception {
        SplittableRandom random = new SplittableRandom(1);
        byte[] message = new byte[6];
        for (int i = 0; i < CALLS; i++) {
            random.nextBytes(message);
            OctetString expected = OctetString.of(new byte[] {message[1], message[2], message[3], message[4]});
            assertEquals(expected, readAndWritten(message), "call " + i);
            assertArrayEquals(expected.toArray(), readAndCopied(message), "call " + i);
        }
    }

    private static OctetString readAndWritten(byte[] message) throws Exception {
        return new OctetWriter().string(from1(message).string(4, "a field")).toOctetString();
    }

    private static byte[] readAndCopied(byte[] message) throws Exception {
        byte[] copy = new byte[4];
        System.arraycopy(from1(message).string(4, "a field").toArray(), 0, copy, 0, copy.length);
        return copy;
    }

    private static OctetReader<Exception> from1(byte[] message) {
        return new OctetReader<>(message, 1, message.length, Exception::new);
    }
}
