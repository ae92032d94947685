package blackbox;

import java.io.Closeable;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.PcmFrames;

/** The second line of an emulated modem, with the sound of its calls, on a TCP port: it plays, and hears the tones. */
public final class ServedSound implements Closeable {
    private static final int FRAME_SAMPLES = PcmFrames.OCTETS / 2;
    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private final ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    private final StringBuffer tonesHeard = new StringBuffer();
    private volatile Socket client;
    private volatile short[] playing = {};
    private volatile int played;
    private volatile int speed = 1;

    public ServedSound() throws IOException {
        thread(this::accept, "sound of the emulated modem");
        thread(this::play, "clock of the emulated modem");
    }

    private interface Work {
        void run() throws IOException;
    }

    private static void thread(Work work, String name) {
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } catch (IOException ended) {
                        // the test is over
                    }
                },
                name);
        thread.setDaemon(true);
        thread.start();
    }

    public int port() {
        return server.getLocalPort();
    }

    private void accept() throws IOException {
        while (true) {
            Socket accepted = server.accept();
            accepted.setTcpNoDelay(true);
            client = accepted;
            try {
                hear(new DataInputStream(accepted.getInputStream()));
            } catch (IOException ended) {
                client = null;
            }
        }
    }

    private void hear(DataInputStream in) throws IOException {
        DtmfReceiver receiver =
                new DtmfReceiver(digit -> tonesHeard.append(digit.key().symbol()));
        byte[] octets = new byte[PcmFrames.OCTETS];
        short[] frame = new short[FRAME_SAMPLES];
        while (true) {
            in.readFully(octets);
            ByteBuffer.wrap(octets)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .asShortBuffer()
                    .get(frame);
            receiver.accept(frame);
        }
    }

    /** A frame each 20 ms, or faster, of the sound or of silence. */
    private void play() {
        long next = System.nanoTime();
        while (!server.isClosed()) {
            int from = played;
            short[] sound = playing;
            send(Arrays.copyOfRange(sound, Math.min(from, sound.length), Math.min(from + FRAME_SAMPLES, sound.length)));
            played = from + FRAME_SAMPLES;
            next += FRAME_NANOS / speed;
            LockSupport.parkNanos(next - System.nanoTime());
        }
    }

    private void send(short[] samples) {
        Socket open = client;
        if (open != null) {
            try {
                open.getOutputStream().write(PcmFrames.octets(Arrays.copyOf(samples, FRAME_SAMPLES)));
            } catch (IOException ended) {
                client = null;
            }
        }
    }

    /** Plays to the end. @param times of real time */
    public void play(short[] samples, int times) {
        playing = samples;
        speed = times;
        played = 0;
        while (played < samples.length) {
            LockSupport.parkNanos(FRAME_NANOS);
        }
        speed = 1;
    }

    public String tonesHeard() {
        return tonesHeard.toString();
    }

    @Override
    public void close() throws IOException {
        server.close();
        Socket open = client;
        if (open != null) {
            open.close();
        }
    }
}
