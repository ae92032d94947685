package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CallRecorderTest {
    @TempDir
    Path folder;

    private static short[] frame(int value) {
        short[] frame = new short[160];
        Arrays.fill(frame, (short) value);
        return frame;
    }

    private static void call(CallRecorder recorder, int frames, int value) {
        recorder.callBegan();
        for (int i = 0; i < frames; i++) {
            recorder.sent(frame(value));
            recorder.received(frame(-value));
        }
        recorder.callEnded();
    }

    /** As any reader of sound files sees it: two channels at 8 kHz. */
    private static short[] read(Path file) throws Exception {
        try (AudioInputStream stream = AudioSystem.getAudioInputStream(file.toFile())) {
            assertEquals(2, stream.getFormat().getChannels());
            assertEquals(8000, stream.getFormat().getSampleRate());
            assertEquals(16, stream.getFormat().getSampleSizeInBits());
            byte[] octets = stream.readAllBytes();
            short[] samples = new short[octets.length / 2];
            ByteBuffer.wrap(octets)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .asShortBuffer()
                    .get(samples);
            return samples;
        }
    }

    @Test
    void leftIsSentAndRightIsReceived() throws Exception {
        Path file = folder.resolve("call.wav");
        CallRecorder recorder = CallRecorder.open(file);
        call(recorder, 13, 5);
        recorder.close();
        short[] samples = read(file);
        assertEquals(13 * 320, samples.length);
        for (int i = 0; i < samples.length; i += 2) {
            assertEquals(5, samples[i]);
            assertEquals(-5, samples[i + 1]);
        }
    }

    @Test
    void theNextCallFollowsAfterHalfASecondOfSilence() throws Exception {
        Path file = folder.resolve("calls.wav");
        CallRecorder recorder = CallRecorder.open(file);
        call(recorder, 2, 5);
        call(recorder, 3, 6);
        recorder.close();
        short[] samples = read(file);
        assertEquals(2 * 320 + 8000 + 3 * 320, samples.length);
        assertArrayEquals(new short[8000], Arrays.copyOfRange(samples, 640, 8640));
        assertEquals(6, samples[8640]);
    }

    @Test
    void theFileIsAWholeOneWhileItGrows() throws Exception {
        Path file = folder.resolve("call.wav");
        CallRecorder recorder = CallRecorder.open(file);
        assertEquals(0, read(file).length);
        recorder.callBegan();
        for (int i = 0; i < 25; i++) {
            recorder.sent(frame(1));
            recorder.received(frame(2));
        }
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            while (read(file).length < 20 * 320) {
                Thread.onSpinWait();
            }
        });
        assertEquals(20 * 320, read(file).length, "all but the last 100 ms");
        recorder.close();
    }

    @Test
    void whatTheFileHeldBeforeIsGone() throws Exception {
        Path file = folder.resolve("old.wav");
        Files.write(file, new byte[100_000]);
        CallRecorder.open(file).close();
        assertEquals(44, Files.size(file));
        assertEquals(0, read(file).length);
    }

    @Test
    void aFileThatCannotBeWrittenIsSaidAtOnce() {
        assertThrows(IOException.class, () -> CallRecorder.open(folder));
        assertThrows(IOException.class, () -> CallRecorder.open(folder.resolve("nowhere" + File.separator + "a.wav")));
    }

    @Test
    void afterTheCloseNothingIsRecordedAndNothingBreaks() throws Exception {
        Path file = folder.resolve("closed.wav");
        CallRecorder recorder = CallRecorder.open(file);
        recorder.close();
        recorder.close();
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> call(recorder, 10_000, 1));
        assertEquals(0, read(file).length);
    }

    @Test
    void aSlowDiskDelaysNoCall() throws Exception {
        CallRecorder recorder = CallRecorder.open(folder.resolve("long.wav"));
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> call(recorder, 100_000, 1));
        recorder.close();
    }
}
