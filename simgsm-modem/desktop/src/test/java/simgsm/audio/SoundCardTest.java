package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.ResourceBundle;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;
import org.junit.jupiter.api.Test;
import simgsm.speech.AudioOutput;

class SoundCardTest {
    private final List<String> logged = new CopyOnWriteArrayList<>();
    private final System.Logger log = new System.Logger() {
        @Override
        public String getName() {
            return "log";
        }

        @Override
        public boolean isLoggable(Level level) {
            return true;
        }

        @Override
        public void log(Level level, ResourceBundle bundle, String text, Throwable thrown) {
            logged.add(level + " " + text);
        }

        @Override
        public void log(Level level, ResourceBundle bundle, String format, Object... parameters) {
            logged.add(level + " " + format);
        }
    };
    /** How many octets each line in turn takes before its device has gone; none: the device is busy. */
    private final BlockingQueue<Integer> devices = new LinkedBlockingQueue<>();

    private final BlockingQueue<String> seen = new LinkedBlockingQueue<>();

    private SourceDataLine next() throws LineUnavailableException {
        Integer octets = devices.poll();
        if (octets == null || octets == 0) {
            seen.add("busy");
            throw new LineUnavailableException("the device is busy");
        }
        int[] left = {octets};
        return (SourceDataLine) Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {SourceDataLine.class}, (proxy, method, arguments) -> {
                    if (!method.getName().equals("write")) {
                        return null;
                    }
                    int taken = Math.min(left[0], (int) arguments[2]);
                    left[0] -= taken;
                    seen.add(taken < (int) arguments[2] ? "gone" : "played");
                    return taken;
                });
    }

    private static void soundUntil(AudioOutput output, BlockingQueue<String> seen, String expected)
            throws InterruptedException {
        short[] frame = new short[160];
        Arrays.fill(frame, (short) 5000);
        for (String last = ""; !last.equals(expected); last = seen.take()) {
            while (seen.isEmpty()) {
                output.play(frame);
                Thread.onSpinWait();
            }
        }
    }

    @Test
    void aDeviceThatIsTakenAwayInACallIsSaidOnceAndUsedAgainOnceItIsBack() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            devices.addAll(List.of(4000, 0, 0, 0, 0, 0, 0, 100_000));
            AudioOutput output = new SoundCard(format -> next(), log, 1);
            soundUntil(output, seen, "gone");
            soundUntil(output, seen, "busy");
            soundUntil(output, seen, "played");
            assertTrue(output.isAudible());
            output.close();
            assertEquals(List.of("WARNING the sound device has gone; looked for again every 1 ms"), logged);
        });
    }

    @Test
    void aBusyDeviceIsSaidOnceAndUsedOnceItIsFree() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            devices.addAll(List.of(0, 0, 0, 0, 0, 0, 0, 100_000));
            AudioOutput output = new SoundCard(format -> next(), log, 1);
            soundUntil(output, seen, "played");
            output.close();
            assertEquals(
                    List.of("INFO no sound device can be opened: the device is busy; looked for again every 1 ms"),
                    logged);
        });
    }

    @Test
    void theSilentTwinIsNeverAudible() {
        AudioOutput.SILENT.play(new short[160]);
        assertFalse(AudioOutput.SILENT.isAudible());
    }

    @Test
    void withOrWithoutADeviceNothingBlocksAndNothingThrows() {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            AudioOutput output = SoundCard.open();
            for (int i = 0; i < 1000; i++) {
                output.play(new short[160]);
            }
            output.close();
            output.play(new short[160]);
            assertFalse(output.isAudible());
        });
    }
}
