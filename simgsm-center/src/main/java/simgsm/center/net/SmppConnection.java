package simgsm.center.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import simgsm.center.smpp.EsmeSession;
import simgsm.center.smpp.SmppPort;

/**
 * An application's TCP connection. What is sent within one turn of the loop goes out in one write; a peer that does not
 * take it is not read from either, until it does.
 */
final class SmppConnection implements Peer, SmppPort {
    /** With more than this unsent, nothing further is read. */
    static final int ENOUGH_UNSENT = 256 * 1024;
    /** With more than this unsent, the peer is not worth keeping. */
    static final int TOO_MUCH_UNSENT = 8 * 1024 * 1024;

    private static final int INITIAL_CAPACITY = 4 * 1024;
    private static final int KEPT_CAPACITY = 64 * 1024;

    /** What the connection needs beside its loop's usual services. */
    interface Server extends Peer.Host {
        void received(SmppConnection connection, ByteBuffer octets);

        void lost(SmppConnection connection, String reason);

        /** There is something to flush at the end of this turn. */
        void hasUnsent(SmppConnection connection);
    }

    private final SocketChannel channel;
    private final SelectionKey key;
    private final Server server;
    private ByteBuffer unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
    private boolean isOpen = true;
    private boolean isAnnounced;
    private boolean isEnding;

    /** What this connection is to the exchange. */
    EsmeSession session;

    SmppConnection(SocketChannel channel, SelectionKey key, Server server) {
        this.channel = channel;
        this.key = key;
        this.server = server;
    }

    @Override
    public boolean isOpen() {
        return isOpen;
    }

    @Override
    public void readable(ByteBuffer buffer) {
        try {
            buffer.clear();
            if (channel.read(buffer) < 0) {
                server.broken(this, "closed by the peer");
                return;
            }
            buffer.flip();
            server.received(this, buffer);
        } catch (IOException e) {
            server.broken(this, String.valueOf(e.getMessage()));
        }
    }

    @Override
    public void send(byte[] pdu) {
        if (!isOpen) {
            return;
        }
        if (unsent.remaining() < pdu.length) {
            grow(pdu.length);
        }
        unsent.put(pdu);
        if (unsent.position() > TOO_MUCH_UNSENT) {
            server.broken(this, unsent.position() + " octets not taken");
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
    void flush() {
        isAnnounced = false;
        if (isOpen) {
            writable();
        }
    }

    @Override
    public void writable() {
        try {
            unsent.flip();
            channel.write(unsent);
            unsent.compact();
            if (unsent.position() == 0 && unsent.capacity() > KEPT_CAPACITY) {
                unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
            }
            listen();
        } catch (IOException e) {
            server.broken(this, String.valueOf(e.getMessage()));
        }
    }

    private void listen() {
        if (unsent.position() == 0 && isEnding) {
            server.broken(this, "ended");
            return;
        }
        int wanted = unsent.position() > 0 ? SelectionKey.OP_WRITE : 0;
        if (unsent.position() < ENOUGH_UNSENT && !isEnding) {
            wanted |= SelectionKey.OP_READ;
        }
        if (key.isValid() && key.interestOps() != wanted) {
            key.interestOps(wanted);
        }
    }

    @Override
    public void closeWhenSent() {
        isEnding = true;
        announce();
    }

    @Override
    public void close(String reason) {
        server.broken(this, reason);
    }

    @Override
    public void shut() {
        if (!isOpen) {
            return;
        }
        isOpen = false;
        server.closed(this);
        key.cancel();
        try {
            channel.close();
        } catch (IOException e) {
            // It is gone either way.
        }
    }

    @Override
    public void lost(String reason) {
        server.lost(this, reason);
    }
}
