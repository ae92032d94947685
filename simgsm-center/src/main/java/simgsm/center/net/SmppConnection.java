package simgsm.center.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import simgsm.center.smpp.EsmeSession;
import simgsm.center.smpp.SmppPort;
import simgsm.center.smpp.SmppServer;
import simgsm.net.Connection;
import simgsm.net.ConnectionLimits;

/**
 * One application's connection to the exchange. The PDUs of one iteration are sent in one write; while a peer does not
 * read them, nothing is read from it.
 */
final class SmppConnection extends Connection implements SmppPort {
    /** Unsent octets above which nothing is read. */
    static final int ENOUGH_UNSENT = 256 * 1024;
    /** Unsent octets above which the peer is disconnected. */
    static final int TOO_MUCH_UNSENT = 8 * 1024 * 1024;

    /** Limit per iteration of a remote peer: 100 to 200 PDUs. */
    private static final int REMOTE_READ_LIMIT = 4 * 1024;

    private static final int INITIAL_CAPACITY = 4 * 1024;
    private static final int KEPT_CAPACITY = 64 * 1024;

    private final CenterLoop center;
    private final SmppServer smpp;
    private final ConnectionLimits places;
    private ByteBuffer unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
    private EsmeSession session;
    private boolean isEnding;

    SmppConnection(Endpoint endpoint, CenterLoop center, SmppServer smpp, ConnectionLimits places) {
        super(endpoint);
        this.places = places;
        this.center = center;
        this.smpp = smpp;
    }

    @Override
    protected void opened() {
        center.changing()
                .perform(center.nowNanos(), () -> session = smpp.opened(this, CenterLoop.text(address()), isLocal()));
    }

    @Override
    protected int readLimit() {
        return isLocal() ? super.readLimit() : REMOTE_READ_LIMIT;
    }

    @Override
    protected void received(ByteBuffer octets) {
        center.changing().perform(center.nowNanos(), () -> session.received(octets));
    }

    @Override
    public void send(byte[] pdu) {
        if (!isOpen()) {
            return;
        }
        if (unsent.remaining() < pdu.length) {
            int needed = unsent.position() + pdu.length;
            unsent =
                    ByteBuffer.allocate(Math.max(needed, 2 * unsent.capacity())).put(unsent.flip());
        }
        unsent.put(pdu);
        if (unsent.position() > TOO_MUCH_UNSENT) {
            fail(unsent.position() + " octets not taken");
        }
        flushLater();
    }

    @Override
    protected void writeTo(WritableByteChannel channel) throws IOException {
        unsent.flip();
        channel.write(unsent);
        unsent.compact();
        if (!hasOutput() && unsent.capacity() > KEPT_CAPACITY) {
            unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
        }
        if (!hasOutput() && isEnding) {
            fail("ended");
        }
    }

    @Override
    protected boolean wantsInput() {
        return unsent.position() < ENOUGH_UNSENT && !isEnding;
    }

    @Override
    protected boolean hasOutput() {
        return unsent.position() > 0;
    }

    @Override
    public void bound() {
        places.proven(address().getAddress());
    }

    @Override
    public void closeWhenSent() {
        isEnding = true;
        flushLater();
    }

    @Override
    public void close(String reason) {
        fail(reason);
    }

    @Override
    protected void lost(String reason) {
        center.changing().perform(center.nowNanos(), () -> session.closed(reason));
    }
}
