package simgsm.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.nio.channels.UnresolvedAddressException;
import java.nio.channels.WritableByteChannel;
import java.util.function.Consumer;

/**
 * An established TCP connection of a {@link SelectorLoop}. Subclasses interpret incoming octets and hold those that
 * wait for the peer. All methods belong to the loop's thread.
 */
public abstract class Connection {
    /**
     * The socket that a connection takes over.
     *
     * @param whenClosed runs once, when either side has closed the socket
     */
    public record Endpoint(
            SelectorLoop loop,
            SocketChannel channel,
            SelectionKey key,
            InetSocketAddress address,
            Runnable whenClosed) {}

    /** Reason of an ordinary end. */
    protected static final String CLOSED_BY_PEER = "closed by the peer";

    private static final System.Logger LOG = System.getLogger(Connection.class.getName());
    private static final int DISMISSAL_OCTETS = 4_096;

    private final Endpoint endpoint;
    private boolean isPaused;
    private boolean isClosedByPeer;
    private boolean isClosed;
    private boolean isFlushScheduled;
    private String failure;

    protected Connection(Endpoint endpoint) {
        this.endpoint = endpoint;
    }

    // Defined by a subclass.

    /** The loop serves the connection from now on. If this throws, the socket is closed and {@link #lost} is not called. */
    protected void opened() {}

    /** Takes all octets of the buffer. */
    protected abstract void received(ByteBuffer octets);

    /** Octets read in one iteration at most. */
    protected int readLimit() {
        return Integer.MAX_VALUE;
    }

    /** False while the peer is to be held back by its own full socket buffer. */
    protected boolean wantsInput() {
        return true;
    }

    protected abstract boolean hasOutput();

    /** Writes waiting output, as far as the channel takes it. */
    protected abstract void writeTo(WritableByteChannel channel) throws IOException;

    /**
     * The peer sends nothing more; it may still read. Called once.
     *
     * @return true if the connection stays open for output; the subclass ends it by {@link #fail}
     */
    protected boolean outlivesInput() {
        return false;
    }

    /** The socket is about to be closed for any reason; called once. */
    protected void closing(boolean isByPeer) {}

    /** The connection was ended by the peer, or by {@link #fail}; not called after {@link #close}. */
    protected void lost(String reason) {}

    // Used by a subclass.

    /** False from the moment the connection is closed or has failed. */
    public final boolean isOpen() {
        return !isClosed && failure == null;
    }

    public final InetSocketAddress address() {
        return endpoint.address;
    }

    /** True if the peer runs on this machine. */
    public final boolean isLocal() {
        return endpoint.address.getAddress().isLoopbackAddress();
    }

    /** Opens a UDP socket on this connection's local address. @param received takes each datagram of the socket's peer */
    protected final Datagrams openDatagrams(Consumer<byte[]> received) throws IOException {
        return Datagrams.open(endpoint.loop, endpoint.channel.socket().getLocalAddress(), received);
    }

    /** Writes waiting output now; the rest when the peer's socket has room. */
    public final void flush() {
        isFlushScheduled = false;
        if (isOpen()) {
            try {
                writeTo(endpoint.channel);
                updateInterest();
            } catch (IOException e) {
                fail(reason(e));
            }
        }
    }

    /** Writes at the end of the iteration, together with its further output. */
    protected final void flushLater() {
        if (!isFlushScheduled) {
            isFlushScheduled = true;
            endpoint.loop.hasOutput(this);
        }
    }

    /** Writes at the end of the running action, together with its further output. */
    protected final void flushAfterAction() {
        endpoint.loop.afterAction(this::flush);
    }

    /** Stops reading until {@link #resumeReading}. */
    protected final void pauseReading() {
        isPaused = true;
        updateInterest();
    }

    protected final void resumeReading() {
        isPaused = false;
        updateInterest();
    }

    /** Runs an action later, if the connection is open then; at the earliest in the next iteration. */
    protected final void after(long delayNanos, Runnable action) {
        endpoint.loop.after(delayNanos, () -> {
            if (isOpen()) {
                guarded(action);
            }
        });
    }

    /** Ends the connection after the running action has returned; then {@link #lost} is called. */
    public final void fail(String reason) {
        if (isOpen()) {
            failure = reason;
            endpoint.loop.afterAction(this::closeAfterFailure);
        }
    }

    /** Closes the socket at once, without {@link #lost}. Safe to call twice. */
    public final void close() {
        if (!isClosed) {
            isClosed = true;
            try {
                closing(isClosedByPeer);
            } finally {
                endpoint.key.cancel();
                closeChannel(endpoint.channel);
                endpoint.whenClosed.run();
            }
        }
    }

    /** Reads once, without waiting for the selector. */
    public final void read() {
        ByteBuffer buffer = endpoint.loop.readBuffer().clear();
        buffer.limit(Math.min(buffer.capacity(), readLimit()));
        try {
            if (endpoint.channel.read(buffer) < 0) {
                isClosedByPeer = true;
                if (outlivesInput()) {
                    pauseReading();
                } else {
                    fail(CLOSED_BY_PEER);
                }
            } else if (buffer.flip().hasRemaining()) {
                received(buffer);
            }
        } catch (IOException e) {
            fail(reason(e));
        }
    }

    /** Closes the socket after reading what the peer has sent, so that the peer sees an end instead of a reset. */
    public final void dismiss() {
        dismiss(endpoint.channel);
        close();
    }

    static void dismiss(SocketChannel channel) {
        try {
            channel.read(ByteBuffer.allocate(DISMISSAL_OCTETS));
            channel.shutdownOutput();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "dismissing a peer: {0}", e.getMessage());
        }
        closeChannel(channel);
    }

    static void closeChannel(SocketChannel channel) {
        try {
            channel.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a socket: {0}", e.getMessage());
        }
    }

    // Used by the loop.

    final void open() {
        endpoint.key.attach(this);
        updateInterest();
        try {
            opened();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "a connection is closed after an internal error", e);
            close();
        }
    }

    final void ready() {
        guarded(() -> {
            if (isOpen() && endpoint.key.isReadable()) {
                read();
            }
            if (isOpen() && endpoint.key.isWritable()) {
                flush();
            }
        });
    }

    final void closeAfterFailure() {
        if (!isClosed) {
            close();
            lost(failure);
        }
    }

    /** An internal error ends the connection in which it occurs. */
    private void guarded(Runnable action) {
        try {
            action.run();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "a connection ends after an internal error", e);
            fail("internal error");
        }
    }

    private void updateInterest() {
        int wanted = (!isPaused && wantsInput() ? SelectionKey.OP_READ : 0) | (hasOutput() ? SelectionKey.OP_WRITE : 0);
        if (isOpen() && endpoint.key.interestOps() != wanted) {
            endpoint.key.interestOps(wanted);
        }
    }

    static String reason(Exception e) {
        if (e instanceof UnresolvedAddressException) {
            return "unknown host";
        }
        return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }
}
