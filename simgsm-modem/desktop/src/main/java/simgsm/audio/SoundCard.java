package simgsm.audio;

import java.io.IOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;
import simgsm.speech.AudioOutput;
import simgsm.speech.OnDemandAudioOutput;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;
import simgsm.thread.DaemonThread;

/**
 * The system's default sound device. Its own thread opens and writes it, because both may block. Samples are dropped
 * while no device is open; an absent, busy or removed device is searched for again.
 */
public final class SoundCard implements AudioOutput {
    /** Finds the line of a device; it is not open yet. */
    interface Lines {
        SourceDataLine line(AudioFormat format) throws LineUnavailableException;
    }

    private static final System.Logger LOG = System.getLogger(SoundCard.class.getName());
    /** Tried in turn: the rate of speech, then a rate of every device. */
    private static final int[] RATES_HERTZ = {SpeechCodec.SAMPLES_PER_SECOND, 48_000};

    private static final int QUEUE_FRAMES = 10;
    /** Room for {@link SoundCushion#MOST_MILLIS} and a frame. Java's ALSA device has periods of 20 ms above 128 ms. */
    private static final int LINE_MILLIS = 160;

    private static final int RETRY_MILLIS = 5_000;
    private static final short[] END = {};

    private final BlockingQueue<short[]> queue = new ArrayBlockingQueue<>(QUEUE_FRAMES);
    private final Thread player = DaemonThread.of("sound-card", this::run);
    private final Lines lines;
    private final System.Logger log;
    private final int retryMillis;
    private boolean isFailureLogged;
    private volatile boolean audible;
    private volatile boolean closed;

    /** Starts opening the device and returns at once. */
    public static AudioOutput open() {
        return open(AudioSystem::getSourceDataLine);
    }

    /** As {@link #open()}, of another device. */
    static AudioOutput open(Lines lines) {
        return new SoundCard(lines, LOG, RETRY_MILLIS);
    }

    /** @throws IOException if there is no such device; one that another program uses is searched for again */
    static void require(Lines lines) throws IOException {
        String reason = "";
        for (int rate : RATES_HERTZ) {
            try {
                lines.line(format(rate));
                return;
            } catch (LineUnavailableException | IllegalArgumentException | SecurityException | LinkageError e) {
                reason = e.getMessage();
            }
        }
        throw new IOException("no sound output of 16 bit, mono: " + reason);
    }

    private static AudioFormat format(int rate) {
        return new AudioFormat(rate, 16, 1, true, false);
    }

    /** The device is opened by the first call of {@link #play}. */
    public static AudioOutput openWhenPlayed() {
        return new OnDemandAudioOutput(SoundCard::open);
    }

    SoundCard(Lines lines, System.Logger log, int retryMillis) {
        this.lines = lines;
        this.log = log;
        this.retryMillis = retryMillis;
        player.start();
    }

    @Override
    public void play(short[] samples) {
        if (!audible || samples.length == 0) {
            return;
        }
        short[] copy = samples.clone();
        while (!queue.offer(copy)) {
            queue.poll();
        }
    }

    @Override
    public boolean isAudible() {
        return audible;
    }

    @Override
    public void close() {
        closed = true;
        audible = false;
        queue.clear();
        queue.offer(END);
    }

    private void run() throws InterruptedException {
        try {
            while (!closed) {
                openAndPlay();
                audible = false;
                // Without a device only the end is queued.
                queue.poll(retryMillis, TimeUnit.MILLISECONDS);
            }
        } finally {
            audible = false;
        }
    }

    private void openAndPlay() throws InterruptedException {
        String reason = "";
        for (int rate : RATES_HERTZ) {
            AudioFormat format = format(rate);
            // without a device getLine throws IllegalArgumentException, not LineUnavailableException
            try (SourceDataLine line = lines.line(format)) {
                line.open(format, rate / 1000 * LINE_MILLIS * 2);
                line.start();
                audible = !closed;
                isFailureLogged = false;
                playOn(line, rate);
                if (!closed) {
                    logFailure(System.Logger.Level.WARNING, "the sound device has gone");
                }
                return;
            } catch (LineUnavailableException | IllegalArgumentException | SecurityException | LinkageError e) {
                reason = e.getMessage();
            }
        }
        logFailure(System.Logger.Level.INFO, "no sound device can be opened: " + reason);
    }

    private void logFailure(System.Logger.Level level, String text) {
        if (!isFailureLogged) {
            isFailureLogged = true;
            log.log(level, text + "; looked for again every " + retryMillis + " ms");
        }
    }

    /** Returns at the end, or if the device accepted less than it was given, since it was removed then. */
    private void playOn(SourceDataLine line, int rate) throws InterruptedException {
        Resampler resampler = new Resampler(SpeechCodec.SAMPLES_PER_SECOND, rate, Resampler.Slope.STEEP);
        SoundCushion cushion = new SoundCushion(System.nanoTime());
        short[] out = new short[rate / 50];
        // Starts the device with silence: PulseAudio needs 0.1 s to start, which delayed the first key's tone.
        short[] samples = new short[SoundCushion.CUSHION_MILLIS * SpeechCodec.SAMPLES_PER_SECOND / 1000];
        while (!closed) {
            float[] in = new float[samples.length];
            for (int i = 0; i < in.length; i++) {
                in[i] = samples[i];
            }
            resampler.write(in, in.length);
            for (int n; (n = resampler.read(out, 0, out.length)) > 0; ) {
                if (line.write(octets(out, n), 0, 2 * n) < 2 * n) {
                    return;
                }
            }
            samples = cushion.accept(queue.take(), System.nanoTime());
        }
    }

    private static byte[] octets(short[] samples, int count) {
        byte[] octets = new byte[2 * count];
        for (int i = 0; i < count; i++) {
            octets[2 * i] = (byte) samples[i];
            octets[2 * i + 1] = (byte) (samples[i] >> 8);
        }
        return octets;
    }
}
