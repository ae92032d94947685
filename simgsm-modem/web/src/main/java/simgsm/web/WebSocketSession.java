package simgsm.web;

import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;

/** One open WebSocket: passes messages on, answers pings, and ends a socket with a silent client. */
final class WebSocketSession implements WebSocket, WebSocketFrames.Receiver {
    /** Ping period; every client answers, so one silent for two periods is gone. */
    static final long PING_NANOS = TimeUnit.SECONDS.toNanos(3);

    private static final byte[] NOTHING = {};

    /** The underlying connection. */
    interface Carrier {
        void send(byte[] frame, boolean isDroppable);

        /** Sends a last frame and closes. */
        void end(byte[] frame);

        void later(long nanos, Runnable action);

        boolean hasOutput();

        InetAddress peer();
    }

    private final Carrier carrier;
    private final WebSocketFrames frames;
    private final WebSocketListener listener;
    private final boolean isLocalPage;
    private boolean isHeard = true;
    private boolean isAsked;
    private boolean isEnded;

    WebSocketSession(WebSocketPath path, Carrier carrier, boolean isLocalPage) {
        this.carrier = carrier;
        this.isLocalPage = isLocalPage;
        frames = new WebSocketFrames(path.mostOctets(), this);
        listener = path.listeners().apply(this);
        carrier.later(PING_NANOS, this::check);
    }

    private void check() {
        if (!isHeard && isAsked) {
            close(WebSocketViolation.PROTOCOL_ERROR, "no answer to a ping");
        } else if (!isEnded) {
            isAsked = !isHeard;
            if (isAsked) {
                carrier.send(WebSocketFrames.encode(WebSocketFrames.PING, NOTHING), false);
            }
            isHeard = false;
            carrier.later(PING_NANOS, this::check);
        }
    }

    void received(ByteBuffer octets) {
        isHeard = true;
        if (isEnded) {
            octets.position(octets.limit());
            return;
        }
        try {
            frames.accept(octets);
        } catch (WebSocketViolation violation) {
            close(violation.code(), violation.getMessage());
        }
    }

    /** The connection has ended. */
    void ended() {
        if (!isEnded) {
            isEnded = true;
            listener.closed();
        }
    }

    private void end(byte[] last) {
        if (!isEnded) {
            carrier.end(last);
            ended();
        }
    }

    @Override
    public void text(String text) {
        if (!isEnded) {
            listener.text(text);
        }
    }

    @Override
    public void binary(byte[] octets) {
        if (!isEnded) {
            listener.binary(octets);
        }
    }

    @Override
    public void ping(byte[] octets) {
        carrier.send(WebSocketFrames.encode(WebSocketFrames.PONG, octets), true);
    }

    @Override
    public void close(int code) {
        end(
                code == WebSocketFrames.NO_CODE
                        ? WebSocketFrames.encode(WebSocketFrames.CLOSE, NOTHING)
                        : WebSocketFrames.close(code, ""));
    }

    @Override
    public void send(String text) {
        if (!isEnded) {
            carrier.send(WebSocketFrames.encode(WebSocketFrames.TEXT, text.getBytes(StandardCharsets.UTF_8)), false);
        }
    }

    @Override
    public void send(byte[] octets) {
        if (!isEnded) {
            carrier.send(WebSocketFrames.encode(WebSocketFrames.BINARY, octets), true);
        }
    }

    @Override
    public void close(int code, String reason) {
        end(WebSocketFrames.close(code, reason));
    }

    @Override
    public boolean hasOutput() {
        return carrier.hasOutput();
    }

    @Override
    public InetAddress peer() {
        return carrier.peer();
    }

    @Override
    public boolean isLocalPage() {
        return isLocalPage;
    }
}
