package simgsm.center.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.nio.channels.WritableByteChannel;

/** One accepted connection, whatever is spoken on it: its socket, and when to read from it and write to it. */
abstract class Peer {
    /** What a connection asks of its loop. */
    interface Host {
        /** The connection cannot go on; the loop closes it once the exchange is at rest. */
        void broken(Peer peer, String reason);

        /** The socket is closed, by whomever. */
        void closed(Peer peer);
    }

    private final Incoming incoming;
    private final Host host;
    private boolean isOpen = true;
    private boolean hasPeerLeft;

    Peer(Incoming incoming, Host host) {
        this.incoming = incoming;
        this.host = host;
    }

    final boolean isOpen() {
        return isOpen;
    }

    final InetAddress address() {
        return incoming.address().getAddress();
    }

    /** Reads once, so that a busy peer does not keep the others waiting. */
    final void readable(ByteBuffer buffer) {
        try {
            buffer.clear().limit(Math.min(buffer.capacity(), mostOctetsAtOnce()));
            if (incoming.channel().read(buffer) < 0) {
                hasPeerLeft = true;
                broken("closed by the peer");
                return;
            }
            received(buffer.flip());
        } catch (IOException e) {
            broken(String.valueOf(e.getMessage()));
        }
    }

    /** What is read in one turn at most. */
    int mostOctetsAtOnce() {
        return Integer.MAX_VALUE;
    }

    /** Takes all octets that the buffer holds. */
    abstract void received(ByteBuffer octets);

    /** Writes what waits, as far as the peer takes it. */
    final void writable() {
        transmit(this::flush);
    }

    abstract void flush(WritableByteChannel channel) throws IOException;

    interface Transmission {
        void to(WritableByteChannel channel) throws IOException;
    }

    /** Writes something, if there is still somebody to write to. */
    final void transmit(Transmission transmission) {
        if (!isOpen) {
            return;
        }
        try {
            transmission.to(incoming.channel());
            listen();
        } catch (IOException e) {
            broken(String.valueOf(e.getMessage()));
        }
    }

    /** Tells the selector what to wait for here. */
    final void listen() {
        int wanted = (wantsToRead() ? SelectionKey.OP_READ : 0) | (wantsToWrite() ? SelectionKey.OP_WRITE : 0);
        SelectionKey key = incoming.key();
        if (key.isValid() && key.interestOps() != wanted) {
            key.interestOps(wanted);
        }
    }

    abstract boolean wantsToRead();

    abstract boolean wantsToWrite();

    final void broken(String reason) {
        host.broken(this, reason);
    }

    /** Closes the socket; once is enough. */
    final void shut() {
        if (!isOpen) {
            return;
        }
        isOpen = false;
        closing(hasPeerLeft);
        host.closed(this);
        incoming.key().cancel();
        try {
            incoming.channel().close();
        } catch (IOException e) {
            // It is gone either way.
        }
    }

    /** The socket is about to be closed. */
    void closing(boolean isByPeer) {}

    /** The exchange is to forget it. */
    abstract void lost(String reason);

    /** A connection as the door takes it in. */
    record Incoming(SocketChannel channel, SelectionKey key, InetSocketAddress address) {}
}
