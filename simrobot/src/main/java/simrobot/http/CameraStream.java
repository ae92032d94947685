package simrobot.http;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import simgsm.thread.DaemonThread;
import simrobot.camera.CameraPictureCache;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/**
 * Sends a camera's pictures to one client as multipart/x-mixed-replace: a part for each picture that differs from the last;
 * an unchanged picture is sent once a second to detect a closed connection. Ends when the client closes the connection or the
 * robot is removed.
 */
final class CameraStream {
    static final String BOUNDARY = "simrobot-frame";

    private static final Logger LOG = System.getLogger(CameraStream.class.getName());
    private static final long SAME_AGAIN_NANOS = 1_000_000_000;

    private final HttpExchange exchange;
    private final String robot;
    private final long periodNanos;
    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private final Thread thread;
    private Runnable whenEnded = () -> {};
    private byte[] sent = {};
    private long sentNanos;

    CameraStream(
            HttpExchange exchange,
            String robot,
            double picturesPerSecond,
            SceneCache scenes,
            CameraPictureCache cameras) {
        this.exchange = exchange;
        this.robot = robot;
        periodNanos = Math.round(1e9 / picturesPerSecond);
        this.scenes = scenes;
        this.cameras = cameras;
        thread = DaemonThread.of("camera stream of " + robot, this::run);
    }

    /**
     * Starts sending.
     *
     * @param ended called at the end
     */
    void start(Runnable ended) {
        whenEnded = ended;
        thread.start();
    }

    private void run() throws InterruptedException {
        try (exchange;
                OutputStream body = exchange.getResponseBody()) {
            write(body, ascii("--" + BOUNDARY + "\r\n"));
            long next = System.nanoTime();
            while (sendPicture(body)) {
                next = Math.max(next + periodNanos, System.nanoTime());
                pauseUntil(next);
            }
        } catch (IOException | IllegalStateException ended) {
            LOG.log(Level.DEBUG, "a stream of {0} ends: {1}", robot, ended.getMessage());
        } finally {
            whenEnded.run();
        }
    }

    private static void pauseUntil(long nanos) throws InterruptedException {
        long left = nanos - System.nanoTime();
        if (left > 0) {
            Thread.sleep(left / 1_000_000, (int) (left % 1_000_000));
        }
    }

    /** @return false if the robot has been removed */
    private boolean sendPicture(OutputStream body) throws IOException, InterruptedException {
        SimulationSnapshot scene = scenes.now();
        Optional<RobotSnapshot> here = scene.robot(robot);
        if (here.isEmpty()) {
            return false;
        }
        byte[] jpeg = cameras.shot(scene, here.get()).jpeg();
        long now = System.nanoTime();
        if (!Arrays.equals(jpeg, sent) || now - sentNanos >= SAME_AGAIN_NANOS) {
            byte[] head = ascii("Content-Type: image/jpeg\r\nContent-Length: " + jpeg.length + "\r\n\r\n");
            // includes the next boundary, because browsers display a part only after its end
            byte[] tail = ascii("\r\n--" + BOUNDARY + "\r\n");
            byte[] part = Arrays.copyOf(head, head.length + jpeg.length + tail.length);
            System.arraycopy(jpeg, 0, part, head.length, jpeg.length);
            System.arraycopy(tail, 0, part, head.length + jpeg.length, tail.length);
            write(body, part);
            sent = jpeg;
            sentNanos = now;
        }
        return true;
    }

    private static void write(OutputStream body, byte[] octets) throws IOException {
        body.write(octets);
        body.flush();
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** Interrupts the thread that runs the stream: the JDK's server closes a connection whose write is interrupted. */
    void close() {
        thread.interrupt();
    }
}
