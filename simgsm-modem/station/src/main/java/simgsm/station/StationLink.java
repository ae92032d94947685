package simgsm.station;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.OutgoingFrames;
import simgsm.air.ProtocolViolation;

/** One station's connection to its centre, made anew as often as it is lost. Owned by the station's thread. */
final class StationLink implements Uplink {
    private static final long FIRST_PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
    private static final long LONGEST_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(5);
    /** A connection that has lasted so long was a good one. */
    private static final long STEADY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private static final int MOST_SIGNALLING_FRAMES = 10_000;
    private static final long CONNECT_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final MobileStation station;
    private final InetSocketAddress center;
    private final StationLog log;
    private final OutgoingFrames outgoing = new OutgoingFrames(MOST_SIGNALLING_FRAMES);
    private IpaFramer framer = new IpaFramer();
    /** Null while there is none. */
    private SocketChannel channel;

    private SelectionKey key;
    private boolean connected;
    private boolean broken;
    private boolean saidAbsent;
    private long pauseNanos = FIRST_PAUSE_NANOS;
    private long upSinceNanos;
    /** The next try to connect, or the end of the present one; without meaning while connected. */
    private long deadlineNanos;

    StationLink(MobileStation station, InetSocketAddress center, long nowNanos) {
        this.station = station;
        this.center = center;
        this.log = new StationLog(station.identity());
        this.deadlineNanos = nowNanos;
    }

    MobileStation station() {
        return station;
    }

    long droppedSpeechFrames() {
        return outgoing.droppedSpeechFrames();
    }

    /** Whether everything that was to be said has been written. */
    boolean isFlushed() {
        return !connected || outgoing.isEmpty();
    }

    long nextDeadlineNanos() {
        long stations = station.nextDeadlineNanos();
        return connected ? stations : Math.min(stations, deadlineNanos);
    }

    @Override
    public void send(IpaFrame frame) {
        if (!connected || broken) {
            return;
        }
        try {
            if (!outgoing.send(frame, channel)) {
                log.trace(Level.WARNING, "the centre reads nothing: link dropped");
                broken = true;
            }
            listenForRoom();
        } catch (IOException e) {
            writeFailed(e);
        }
    }

    @Override
    public void drop() {
        broken = true;
    }

    /** Does what is due by time, and gives up a connection that has broken. */
    void timePassed(Selector selector, long nowNanos) {
        station.timePassed(nowNanos);
        if (!connected && nowNanos >= deadlineNanos) {
            if (channel == null) {
                connect(selector, nowNanos);
            } else {
                failed("no answer", nowNanos);
            }
        }
        dropIfBroken(nowNanos);
    }

    void dropIfBroken(long nowNanos) {
        if (broken) {
            lost(nowNanos);
        }
    }

    /** The selector says that the channel is ready for something. */
    void ready(ByteBuffer buffer, long nowNanos) {
        if (key.isValid() && key.isConnectable()) {
            finishConnect(nowNanos);
        }
        if (connected && key.isValid() && key.isWritable()) {
            write();
        }
        if (connected && key.isValid() && key.isReadable()) {
            read(buffer, nowNanos);
        }
        dropIfBroken(nowNanos);
    }

    private void connect(Selector selector, long nowNanos) {
        try {
            channel = SocketChannel.open();
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            key = channel.register(selector, 0, this);
            deadlineNanos = nowNanos + CONNECT_NANOS;
            if (channel.connect(resolved())) {
                up(nowNanos);
            } else {
                key.interestOps(SelectionKey.OP_CONNECT);
            }
        } catch (IOException | RuntimeException e) {
            failed(reason(e), nowNanos);
        }
    }

    /** A name that could not be resolved is asked for again. */
    private InetSocketAddress resolved() {
        return center.isUnresolved() ? new InetSocketAddress(center.getHostString(), center.getPort()) : center;
    }

    private void finishConnect(long nowNanos) {
        try {
            channel.finishConnect();
            up(nowNanos);
        } catch (IOException e) {
            failed(reason(e), nowNanos);
        }
    }

    private void up(long nowNanos) {
        connected = true;
        saidAbsent = false;
        upSinceNanos = nowNanos;
        framer = new IpaFramer();
        key.interestOps(SelectionKey.OP_READ);
        log.trace(Level.INFO, "connected to the centre at {0}", address());
        station.linkUp(this, nowNanos);
    }

    private String address() {
        return center.getHostString() + ":" + center.getPort();
    }

    private void failed(String reason, long nowNanos) {
        if (!saidAbsent) {
            saidAbsent = true;
            log.trace(Level.WARNING, "no centre at {0} ({1}); trying again", address(), reason);
        }
        lost(nowNanos);
    }

    /** A centre that takes connections only to close them at once is not asked in quick succession. */
    private void lost(long nowNanos) {
        if (connected && nowNanos - upSinceNanos > STEADY_NANOS) {
            pauseNanos = FIRST_PAUSE_NANOS;
        }
        if (connected && !saidAbsent) {
            log.trace(Level.WARNING, "the link to the centre is lost; trying again");
        }
        close();
        deadlineNanos = nowNanos + pauseNanos;
        pauseNanos = Math.min(2 * pauseNanos, LONGEST_PAUSE_NANOS);
        station.linkDown(nowNanos);
    }

    void close() {
        connected = false;
        broken = false;
        outgoing.clear();
        if (channel != null) {
            try {
                channel.close();
            } catch (IOException e) {
                log.trace(Level.DEBUG, "closing: {0}", reason(e));
            }
            channel = null;
        }
    }

    private void write() {
        try {
            outgoing.flush(channel);
            listenForRoom();
        } catch (IOException e) {
            writeFailed(e);
        }
    }

    private void writeFailed(IOException e) {
        log.trace(Level.DEBUG, "write: {0}", reason(e));
        broken = true;
    }

    private void listenForRoom() {
        key.interestOps(outgoing.isEmpty() ? SelectionKey.OP_READ : SelectionKey.OP_READ | SelectionKey.OP_WRITE);
    }

    private void read(ByteBuffer buffer, long nowNanos) {
        try {
            buffer.clear();
            if (channel.read(buffer) < 0) {
                broken = true;
                return;
            }
            framer.accept(buffer.flip());
            for (var frame = framer.next(); frame.isPresent() && !broken; frame = framer.next()) {
                station.frameArrived(frame.get(), nowNanos);
            }
        } catch (IOException e) {
            log.trace(Level.DEBUG, "read: {0}", reason(e));
            broken = true;
        } catch (ProtocolViolation e) {
            log.trace(Level.WARNING, "{0}: link dropped", e.getMessage());
            broken = true;
        }
    }

    private static String reason(Exception e) {
        return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }
}
