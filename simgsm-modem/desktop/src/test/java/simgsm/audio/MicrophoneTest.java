package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.concurrent.Semaphore;
import java.util.concurrent.SynchronousQueue;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.TargetDataLine;
import org.junit.jupiter.api.Test;
import simgsm.speech.PcmFrames;

class MicrophoneTest {
    /** Frames that the device gives; one without octets is its end. */
    private final SynchronousQueue<byte[]> device = new SynchronousQueue<>();
    /** A permit for each read that has begun: all frames before it are queued. */
    private final Semaphore reads = new Semaphore(0);

    private TargetDataLine line() {
        return (TargetDataLine) Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {TargetDataLine.class}, (proxy, method, arguments) -> {
                    if (!method.getName().equals("read")) {
                        return null;
                    }
                    reads.release();
                    byte[] octets = device.take();
                    System.arraycopy(octets, 0, (byte[]) arguments[0], 0, octets.length);
                    return octets.length;
                });
    }

    private void give(int value) throws InterruptedException {
        short[] frame = new short[160];
        java.util.Arrays.fill(frame, (short) value);
        reads.acquire();
        device.put(PcmFrames.octets(frame));
        reads.acquire();
        reads.release();
    }

    private static int next(Microphone microphone) {
        short[] frame = new short[160];
        microphone.read(frame);
        assertEquals(frame[0], frame[159]);
        return frame[0];
    }

    @Test
    void theFirstFrameIsHeldUntilThreeWaitAndAgainAfterTheQueueRanEmpty() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            try (Microphone microphone = new Microphone(format -> line())) {
                give(1);
                give(2);
                assertEquals(0, next(microphone));
                give(3);
                assertEquals(1, next(microphone));
                assertEquals(2, next(microphone));
                assertEquals(3, next(microphone));
                assertEquals(0, next(microphone));
                give(4);
                assertEquals(0, next(microphone));
            }
        });
    }

    @Test
    void soundOfBeforeTheCallIsNotHeardInIt() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            try (Microphone microphone = new Microphone(format -> line())) {
                for (int i = 1; i <= 12; i++) {
                    give(i);
                }
                microphone.begin();
                for (int i = 13; i <= 15; i++) {
                    give(i);
                }
                assertEquals(13, next(microphone));
            }
        });
    }

    @Test
    void ofMoreThanTenFramesTheOldestAreDropped() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            try (Microphone microphone = new Microphone(format -> line())) {
                for (int i = 1; i <= 13; i++) {
                    give(i);
                }
                assertEquals(4, next(microphone));
            }
        });
    }

    @Test
    void aMissingDeviceIsSaidWithTheFormatAndTheReason() {
        IOException refused = assertThrows(
                IOException.class,
                () -> new Microphone(format -> {
                    throw new LineUnavailableException("the device is busy");
                }));
        assertEquals("no sound input of 8 kHz, 16 bit, mono: the device is busy", refused.getMessage());
        assertTrue(refused.getCause() instanceof LineUnavailableException);
    }
}
