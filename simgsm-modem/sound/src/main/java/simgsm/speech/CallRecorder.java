package simgsm.speech;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * Records a station's calls in one WAV file: left channel sent, right channel received, 0.5 s of silence between calls. A
 * separate thread writes. The file is valid after each 200 ms of speech, even if the program is killed.
 */
public final class CallRecorder implements CallAudioListener {
    private static final System.Logger LOG = System.getLogger(CallRecorder.class.getName());

    private static final int CHANNELS = 2;
    private static final int GAP_SAMPLES = SpeechCodec.SAMPLES_PER_SECOND / 2 * CHANNELS;
    /** Most blocks waiting for a slow disk: 13 s of speech. */
    private static final int QUEUE_BLOCKS = 64;

    private static final long CLOSE_SECONDS = 2;
    private static final short[] END = {};

    private final Path path;
    private final WavWriter file;
    private final CallInterleaver interleaver = new CallInterleaver(this::queue);
    private final BlockingQueue<short[]> queue = new ArrayBlockingQueue<>(QUEUE_BLOCKS);
    private final Thread writer;
    private boolean hasRecorded;
    private boolean hasLoggedLoss;

    private CallRecorder(Path path, WavWriter file) {
        this.path = path;
        this.file = file;
        writer = new Thread(this::write, "recorder");
        writer.setDaemon(true);
        writer.start();
    }

    /**
     * Begins a recording; an existing file is replaced.
     *
     * @throws IOException if the file cannot be written
     */
    public static CallRecorder open(Path path) throws IOException {
        try {
            return new CallRecorder(path, new WavWriter(path, CHANNELS));
        } catch (FileSystemException e) {
            throw e; // Contains the file's name.
        } catch (IOException e) {
            throw new IOException(path + ": " + e.getMessage(), e);
        }
    }

    @Override
    public void callBegan() {
        if (hasRecorded) {
            queue(new short[GAP_SAMPLES]);
        }
        hasRecorded = true;
    }

    @Override
    public void sent(short[] frame) {
        interleaver.sent(frame);
    }

    @Override
    public void received(short[] frame) {
        interleaver.received(frame);
    }

    @Override
    public void callEnded() {
        interleaver.end();
    }

    private void queue(short[] block) {
        if (writer.isAlive() && !queue.offer(block) && !hasLoggedLoss) {
            hasLoggedLoss = true;
            LOG.log(Level.WARNING, "{0}: the disk does not keep up, speech is missing", path);
        }
    }

    private void write() {
        try (file) {
            for (short[] block = queue.take(); block != END; block = queue.take()) {
                file.write(block);
                file.commit();
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: recording ends: {1}", path, e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Writes the rest, for at most 2 s. Any thread may call it, repeatedly. */
    @Override
    public void close() {
        try {
            if (writer.isAlive() && queue.offer(END, CLOSE_SECONDS, TimeUnit.SECONDS)) {
                writer.join(TimeUnit.SECONDS.toMillis(CLOSE_SECONDS));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
