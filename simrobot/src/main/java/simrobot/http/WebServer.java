package simrobot.http;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.util.Locale;
import simgsm.web.WebPort;
import simrobot.camera.CameraPictureCache;

/** SimRobot's read-only web server. */
public final class WebServer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(WebServer.class.getName());

    private final WebPort port;
    private final CameraStreams streams;

    /**
     * Opens the port; requests are answered after {@link #start}.
     *
     * @param port 0 for any free port
     * @throws IOException with the port's number if it cannot be opened
     */
    public WebServer(InetAddress address, int port, Locale language, WebSource source) throws IOException {
        this(address, port, language, source, WebPort.WRITE_LIMIT_NANOS);
    }

    WebServer(InetAddress address, int port, Locale language, WebSource source, long writeLimitNanos)
            throws IOException {
        SceneCache scenes = new SceneCache(source);
        CameraPictureCache cameras = new CameraPictureCache();
        streams = new CameraStreams(scenes, cameras);
        this.port = new WebPort(
                address, port, new Router(source, scenes, cameras, streams, new Page(language)), writeLimitNanos);
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
