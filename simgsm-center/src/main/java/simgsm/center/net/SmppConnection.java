package simgsm.center.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import simgsm.center.smpp.EsmeSession;
import simgsm.center.smpp.SmppPort;

/**
 * An application's TCP connection. What is sent within one turn of the loop goes out in one write; a peer that does not
 * take it is not read from either, until it does.
 */
final class SmppConnection extends Peer implements SmppPort {
    /** With more than this unsent, nothing further is read. */
    static final int ENOUGH_UNSENT = 256 * 1024;
    /** With more than this unsent, the peer is not worth keeping. */
    static final int TOO_MUCH_UNSENT = 8 * 1024 * 1024;

    /** From another machine: a hundred or two requests, before the others have their turn. */
    private static final int REMOTE_OCTETS_AT_ONCE = 4 * 1024;

    private static final int INITIAL_CAPACITY = 4 * 1024;
    private static final int KEPT_CAPACITY = 64 * 1024;

    /** What the connection needs beside its loop's usual services. */
    interface Server extends Peer.Host {
        void received(SmppConnection connection, ByteBuffer octets);

        void lost(SmppConnection connection, String reason);

        /** There is something to write at the end of this turn. */
        void hasUnsent(SmppConnection connection);
    }

    private final Server server;
    private ByteBuffer unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
    private boolean isAnnounced;
    private boolean isEnding;

    /** What this connection is to the exchange. */
    EsmeSession session;

    SmppConnection(Incoming incoming, Server server) {
        super(incoming, server);
        this.server = server;
    }

    @Override
    int mostOctetsAtOnce() {
        return address().isLoopbackAddress() ? super.mostOctetsAtOnce() : REMOTE_OCTETS_AT_ONCE;
    }

    @Override
    void received(ByteBuffer octets) {
        server.received(this, octets);
    }

    @Override
    public void send(byte[] pdu) {
        if (!isOpen()) {
            return;
        }
        if (unsent.remaining() < pdu.length) {
            grow(pdu.length);
        }
        unsent.put(pdu);
        if (unsent.position() > TOO_MUCH_UNSENT) {
            broken(unsent.position() + " octets not taken");
        }
        announce();
    }

    private void grow(int more) {
        int needed = unsent.position() + more;
        ByteBuffer larger = ByteBuffer.allocate(Math.max(needed, 2 * unsent.capacity()));
        unsent = larger.put(unsent.flip());
    }

    private void announce() {
        if (!isAnnounced) {
            isAnnounced = true;
            server.hasUnsent(this);
        }
    }

    /** Writes what the turn has brought. */
    void endTurn() {
        isAnnounced = false;
        writable();
    }

    @Override
    void flush(WritableByteChannel channel) throws IOException {
        unsent.flip();
        channel.write(unsent);
        unsent.compact();
        if (unsent.position() == 0 && unsent.capacity() > KEPT_CAPACITY) {
            unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
        }
        if (unsent.position() == 0 && isEnding) {
            broken("ended");
        }
    }

    @Override
    boolean wantsToRead() {
        return unsent.position() < ENOUGH_UNSENT && !isEnding;
    }

    @Override
    boolean wantsToWrite() {
        return unsent.position() > 0;
    }

    @Override
    public void closeWhenSent() {
        isEnding = true;
        announce();
    }

    @Override
    public void close(String reason) {
        broken(reason);
    }

    @Override
    void lost(String reason) {
        server.lost(this, reason);
    }
}
