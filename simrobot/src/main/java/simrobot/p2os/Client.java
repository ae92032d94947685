package simrobot.p2os;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Deque;
import simrobot.robot.SimulatedRobot;
import vericommand.Pose;

/**
 * A client's connection. Its bytes go to the session on the simulation's thread, one chunk at a time, so that a flood
 * waits in the sender's own buffers; packets to a client that does not read are dropped.
 */
final class Client implements PacketOutput {
    private static final Logger LOG = System.getLogger(Client.class.getName());
    private static final int CHUNK = 2048;

    /** Whoever says nothing valid for so long is no client yet. */
    private static final long HANDSHAKE_NANOS = 500_000_000;

    private static final int MOST_QUEUED_PACKETS = 100;

    private final P2osServer server;
    private final P2osAcceptor door;
    private final SocketChannel channel;
    private final SelectionKey key;
    private final ByteBuffer input = ByteBuffer.allocate(CHUNK);
    private final Deque<ByteBuffer> output = new ArrayDeque<>();
    private P2osSession session;
    private boolean reading = true;
    private boolean gone;

    Client(P2osServer server, P2osAcceptor door, SocketChannel channel) throws IOException {
        this.server = server;
        this.door = door;
        this.channel = channel;
        channel.configureBlocking(false);
        channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
        key = channel.register(server.selector(), SelectionKey.OP_READ, this);
    }

    void begin(SimulatedRobot robot, Pose start) {
        session = new P2osSession(robot, start, this, System.nanoTime());
        server.add(session);
    }

    boolean isSilent(long nanos) {
        long patience = session.isOpen() ? P2osSession.WATCHDOG_NANOS : HANDSHAKE_NANOS;
        return nanos - session.receivedNanos() > patience;
    }

    // ---- any thread ------------------------------------------------------------------------------------------------

    @Override
    public void send(byte[] packet) {
        server.post(() -> queue(packet));
    }

    @Override
    public void close() {
        server.post(() -> {
            write();
            drop();
        });
    }

    // ---- the sockets' thread ---------------------------------------------------------------------------------------

    void serve() {
        try {
            if (key.isValid() && key.isReadable()) {
                read();
            }
            if (key.isValid() && key.isWritable()) {
                write();
            }
        } catch (CancelledKeyException e) {
            drop();
        }
    }

    /** Finds out whether it has gone, though its bytes may not be wanted just now. */
    void notice() {
        if (!gone) {
            read();
        }
    }

    private void read() {
        try {
            input.clear();
            if (channel.read(input) < 0) {
                drop();
                return;
            }
        } catch (IOException e) {
            drop();
            return;
        }
        if (input.position() > 0) {
            byte[] bytes = new byte[input.flip().remaining()];
            input.get(bytes);
            reading = false;
            setInterest();
            server.simulation().withSimulation(owned -> {
                try {
                    session.received(bytes, owned.timeNanos(), System.nanoTime());
                } finally {
                    server.post(this::readOn);
                }
            });
        }
    }

    private void readOn() {
        reading = true;
        setInterest();
    }

    private void queue(byte[] packet) {
        if (gone || output.size() >= MOST_QUEUED_PACKETS) {
            return;
        }
        output.add(ByteBuffer.wrap(packet));
        write();
    }

    private void write() {
        try {
            while (!gone && !output.isEmpty()) {
                channel.write(output.peek());
                if (output.peek().hasRemaining()) {
                    break;
                }
                output.remove();
            }
        } catch (IOException e) {
            drop();
        }
        setInterest();
    }

    private void setInterest() {
        if (!gone && key.isValid()) {
            key.interestOps((reading ? SelectionKey.OP_READ : 0) | (output.isEmpty() ? 0 : SelectionKey.OP_WRITE));
        }
    }

    /** Ends the connection at once. */
    void drop() {
        if (gone) {
            return;
        }
        gone = true;
        try {
            channel.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing failed", e);
        }
        server.remove(session);
        server.simulation().post(session::lost);
        door.left(this);
    }
}
