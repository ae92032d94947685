package simrobot.p2os;

import java.nio.ByteBuffer;
import simgsm.net.OutputQueue;
import simgsm.net.QueuedConnection;

/**
 * A client's connection. Its octets go to the session on the simulation's thread, one read at a time, so that a flood
 * fills the client's own socket. At most 100 unread packets are kept for a client; further ones are dropped.
 */
final class P2osClientConnection extends QueuedConnection {
    private static final int READ_LIMIT = 2048;

    /** Time without a valid packet after which a client is disconnected for a waiting one. */
    private static final long HANDSHAKE_NANOS = 500_000_000;

    private static final int MOST_QUEUED_PACKETS = 100;

    private final P2osServer server;
    private final P2osPort port;
    private final long acceptedNanos = System.nanoTime();
    /** Null while the client waits. */
    private P2osSession session;

    /** Output of the session, called on the simulation's thread. */
    private final class SessionOutput implements PacketOutput {
        @Override
        public void send(byte[] packet) {
            server.post(() -> queue(packet));
        }

        @Override
        public void close() {
            server.post(() -> {
                flush();
                P2osClientConnection.this.close();
            });
        }
    }

    P2osClientConnection(Endpoint endpoint, P2osServer server, P2osPort port) {
        super(endpoint, new OutputQueue(MOST_QUEUED_PACKETS, 0, written -> {}));
        this.server = server;
        this.port = port;
    }

    /** Returns the real time of the connection's acceptance. */
    long acceptedNanos() {
        return acceptedNanos;
    }

    /** Begins the session; nothing is read before. */
    void begin() {
        session =
                new P2osSession(port.robot(), port.start(), new SessionOutput(), server.requests(), System.nanoTime());
        server.add(session);
        resumeReading();
    }

    boolean isSilent(long nowNanos) {
        long limit = session.isOpen() ? P2osSession.WATCHDOG_NANOS : HANDSHAKE_NANOS;
        return nowNanos - session.receivedNanos() > limit;
    }

    private void queue(byte[] packet) {
        if (output().size() < MOST_QUEUED_PACKETS) {
            write(packet, false);
        }
    }

    @Override
    protected void opened() {
        port.accepted(this);
    }

    @Override
    protected int readLimit() {
        return READ_LIMIT;
    }

    @Override
    protected boolean wantsInput() {
        return session != null;
    }

    @Override
    protected void received(ByteBuffer octets) {
        byte[] chunk = new byte[octets.remaining()];
        octets.get(chunk);
        pauseReading();
        server.simulation().withSimulation(simulation -> {
            try {
                session.received(chunk, simulation.timeNanos(), System.nanoTime());
            } finally {
                server.post(this::resumeReading);
            }
        });
    }

    @Override
    protected void closing(boolean isByPeer) {
        if (session != null) {
            server.remove(session);
            server.simulation().post(session::lost);
        }
        port.closed(this);
    }
}
