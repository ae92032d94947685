package simgsm.audio;

import java.io.IOException;
import java.util.Arrays;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.TargetDataLine;
import simgsm.speech.AudioInput;
import simgsm.speech.PcmFrames;
import simgsm.thread.DaemonThread;

/**
 * The input of the system's default sound device. Its own thread reads, because reading blocks. Two frames wait before
 * the first is taken, which hides the jitter of device and call; of more than ten the oldest is dropped, which hides the
 * drift of their clocks.
 */
public final class Microphone implements AudioInput {
    /** Finds the line of a device; it is not open yet. */
    interface Lines {
        TargetDataLine line(AudioFormat format) throws LineUnavailableException;
    }

    private static final System.Logger LOG = System.getLogger(Microphone.class.getName());
    static final AudioFormat FORMAT = new AudioFormat(8_000, 16, 1, true, false);
    /** 100 ms. */
    static final int LINE_OCTETS = 5 * PcmFrames.OCTETS;

    private static final int FIRST_FRAMES = 3;
    private static final int MOST_FRAMES = 10;

    private final TargetDataLine line;
    private final BlockingQueue<short[]> queue = new ArrayBlockingQueue<>(MOST_FRAMES);
    private boolean isFlowing;
    private volatile boolean isClosed;

    /** Opens the default device. @throws IOException with the reason if there is none */
    public static Microphone open() throws IOException {
        return new Microphone(AudioSystem::getTargetDataLine);
    }

    Microphone(Lines lines) throws IOException {
        line = started(lines);
        DaemonThread.start("microphone", this::run);
    }

    /** An open line that takes sound. */
    static TargetDataLine started(Lines lines) throws IOException {
        try {
            TargetDataLine line = lines.line(FORMAT);
            line.open(FORMAT, LINE_OCTETS);
            line.start();
            return line;
        } catch (LineUnavailableException | IllegalArgumentException | SecurityException | LinkageError e) {
            // without a device getTargetDataLine throws IllegalArgumentException
            throw new IOException("no sound input of 8 kHz, 16 bit, mono: " + e.getMessage(), e);
        }
    }

    private void run() {
        PcmFrames frames = new PcmFrames(frame -> {
            while (!queue.offer(frame)) {
                queue.poll();
            }
        });
        byte[] octets = new byte[PcmFrames.OCTETS];
        for (int n; !isClosed && (n = line.read(octets, 0, octets.length)) > 0; ) {
            frames.accept(Arrays.copyOf(octets, n));
        }
        if (!isClosed) {
            LOG.log(System.Logger.Level.WARNING, "the microphone has gone; calls go on without it");
        }
    }

    @Override
    public void begin() {
        queue.clear();
        isFlowing = false;
    }

    @Override
    public void read(short[] frame) {
        isFlowing = isFlowing || queue.size() >= FIRST_FRAMES;
        short[] next = isFlowing ? queue.poll() : null;
        isFlowing = next != null;
        if (isFlowing) {
            System.arraycopy(next, 0, frame, 0, frame.length);
        }
    }

    @Override
    public void close() {
        isClosed = true;
        line.close();
    }
}
