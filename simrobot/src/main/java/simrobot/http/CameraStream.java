package simrobot.http;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/**
 * One who watches a camera: multipart/x-mixed-replace, a part for each picture that differs from the last, and now and then
 * one that does not, to find out whether anybody is still there. Ends when the client or the robot goes.
 */
final class CameraStream implements Runnable {
    static final String BOUNDARY = "simrobot-frame";

    private static final Logger LOG = System.getLogger(CameraStream.class.getName());
    private static final long SAME_AGAIN_NANOS = 1_000_000_000;
    private static final long NOT_WRITING = Long.MIN_VALUE;

    private final HttpExchange exchange;
    private final String robot;
    private final long periodNanos;
    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private volatile long writingSince = NOT_WRITING;
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
    }

    @Override
    public void run() {
        try (exchange;
                OutputStream body = exchange.getResponseBody()) {
            write(body, ascii("--" + BOUNDARY + "\r\n"));
            long next = System.nanoTime();
            while (sendPicture(body)) {
                next = Math.max(next + periodNanos, System.nanoTime());
                pauseUntil(next);
            }
        } catch (IOException | IllegalStateException gone) {
            LOG.log(Level.DEBUG, "a stream of {0} ends: {1}", robot, gone.getMessage());
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    private static void pauseUntil(long nanos) throws InterruptedException {
        long left = nanos - System.nanoTime();
        if (left > 0) {
            Thread.sleep(left / 1_000_000, (int) (left % 1_000_000));
        }
    }

    /** @return false when the robot is there no more */
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
            // the boundary behind it goes with it: browsers show a part when they see its end
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

    private void write(OutputStream body, byte[] octets) throws IOException {
        writingSince = System.nanoTime();
        body.write(octets);
        body.flush();
        writingSince = NOT_WRITING;
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** Whether the client has taken nothing for so long. */
    boolean isStuck(long nowNanos, long patienceNanos) {
        long since = writingSince;
        return since != NOT_WRITING && nowNanos - since > patienceNanos;
    }

    /** Ends it from another thread; a write that hangs fails. */
    void cut() {
        exchange.close();
    }
}
