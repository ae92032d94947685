package simgsm.audio;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;
import simgsm.speech.AudioOutput;
import simgsm.speech.OnDemandAudioOutput;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;

/**
 * The system's default sound device. A thread of its own opens it and writes to it, because both may block. Samples are
 * dropped until it is open, and always when there is none.
 */
public final class SoundCard implements AudioOutput {
    private static final System.Logger LOG = System.getLogger(SoundCard.class.getName());
    /** Tried in turn: the rate of speech, then a rate that every device has. */
    private static final int[] RATES_HERTZ = {SpeechCodec.SAMPLES_PER_SECOND, 48_000};

    private static final int QUEUE_FRAMES = 10;
    private static final int LINE_MILLIS = 100;
    private static final short[] END = {};

    private final BlockingQueue<short[]> queue = new ArrayBlockingQueue<>(QUEUE_FRAMES);
    private final Thread player = new Thread(this::run, "sound-card");
    private volatile boolean audible;
    private volatile boolean closed;

    /** Begins to open the device and returns at once. */
    public static AudioOutput open() {
        return new SoundCard();
    }

    /** The device is opened by the first call of {@link #play}. */
    public static AudioOutput openWhenPlayed() {
        return new OnDemandAudioOutput(SoundCard::open);
    }

    private SoundCard() {
        player.setDaemon(true);
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

    private void run() {
        for (int rate : RATES_HERTZ) {
            AudioFormat format = new AudioFormat(rate, 16, 1, true, false);
            // without a device getLine throws IllegalArgumentException, not LineUnavailableException
            try (SourceDataLine line = AudioSystem.getSourceDataLine(format)) {
                line.open(format, rate / 1000 * LINE_MILLIS * 2);
                line.start();
                audible = !closed;
                playOn(line, rate);
                return;
            } catch (LineUnavailableException | IllegalArgumentException | SecurityException | LinkageError e) {
                LOG.log(System.Logger.Level.DEBUG, "no sound at " + rate + " Hz: " + e.getMessage());
            } catch (InterruptedException e) {
                return;
            } finally {
                audible = false;
            }
        }
    }

    private void playOn(SourceDataLine line, int rate) throws InterruptedException {
        Resampler resampler = new Resampler(SpeechCodec.SAMPLES_PER_SECOND, rate, Resampler.Slope.STEEP);
        short[] out = new short[rate / 50];
        while (!closed) {
            short[] samples = queue.take();
            float[] in = new float[samples.length];
            for (int i = 0; i < in.length; i++) {
                in[i] = samples[i];
            }
            resampler.write(in, in.length);
            for (int n; (n = resampler.read(out, 0, out.length)) > 0; ) {
                line.write(octets(out, n), 0, 2 * n);
            }
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
