package simrobot.http;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.util.Locale;
import java.util.Optional;
import simgsm.web.AccessKeys;
import simgsm.web.WebPort;
import simrobot.camera.CameraPictureCache;

/** SimRobot's web server: read-only, or with keys for orders. */
public final class WebServer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(WebServer.class.getName());

    private final WebPort port;
    private final CameraStreams streams;

    /**
     * Opens the port; {@link #start} begins answering.
     *
     * @param port 0 for any free port
     * @param keys of programs that may order; may be empty
     * @throws IOException with the port's number if it cannot be opened
     */
    public WebServer(InetAddress address, int port, Locale language, WebSource source, Optional<AccessKeys> keys)
            throws IOException {
        this(address, port, language, source, keys, WebPort.WRITE_LIMIT_NANOS);
    }

    WebServer(
            InetAddress address,
            int port,
            Locale language,
            WebSource source,
            Optional<AccessKeys> keys,
            long writeLimitNanos)
            throws IOException {
        SceneCache scenes = new SceneCache(source);
        CameraPictureCache cameras = new CameraPictureCache();
        streams = new CameraStreams(scenes, cameras);
        Optional<OrderPages> orders = keys.map(known -> new OrderPages(known, source));
        Router router = new Router(source, scenes, cameras, streams, new Page(language), orders);
        this.port = new WebPort(address, port, router, writeLimitNanos);
    }

    public int port() {
        return port.port();
    }

    public void start() {
        port.start();
        LOG.log(Level.INFO, "pictures and status on {0}", port.url());
    }

    @Override
    public void close() {
        streams.close();
        port.close();
    }
}
