package simgsm.gateway;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import simgsm.gateway.mail.MailProtocol;
import simgsm.gateway.mail.MailSocket;
import simgsm.net.Connection;

/** A TCP connection of mail: to the SMSC, to the mail server, or of a mail client. */
final class MailConnection extends Connection implements MailSocket {
    private static final int MOST_UNSENT = 1024 * 1024;
    private static final long LINGER_NANOS = TimeUnit.SECONDS.toNanos(10);

    private final CoreTime time;
    private final MailProtocol protocol;
    private final Runnable closed;
    private final Queue<ByteBuffer> unsent = new ArrayDeque<>();
    private int unsentOctets;
    private boolean isEnding;

    /** @param closed runs once the socket is closed */
    MailConnection(Endpoint endpoint, CoreTime time, MailProtocol protocol, Runnable closed) {
        super(endpoint);
        this.time = time;
        this.protocol = protocol;
        this.closed = closed;
    }

    @Override
    protected void opened() {
        time.advance();
        protocol.connected(this);
    }

    @Override
    protected void received(ByteBuffer octets) {
        time.advance();
        protocol.received(octets);
    }

    @Override
    public void send(byte[] octets) {
        unsent.add(ByteBuffer.wrap(octets));
        unsentOctets += octets.length;
        if (unsentOctets > MOST_UNSENT) {
            fail(unsentOctets + " octets not taken");
        }
        flushAfterAction();
    }

    @Override
    protected boolean hasOutput() {
        return !unsent.isEmpty();
    }

    @Override
    protected void writeTo(WritableByteChannel channel) throws IOException {
        while (!unsent.isEmpty()) {
            unsentOctets -= channel.write(unsent.element());
            if (unsent.element().hasRemaining()) {
                return;
            }
            unsent.remove();
        }
        if (isEnding) {
            fail("ended");
        }
    }

    @Override
    protected boolean wantsInput() {
        return !isEnding;
    }

    @Override
    public void closeWhenSent() {
        isEnding = true;
        flushAfterAction();
        after(LINGER_NANOS, () -> fail("does not read"));
    }

    @Override
    protected void lost(String reason) {
        closed.run();
        if (!isEnding) {
            time.advance();
            protocol.lost(reason);
        }
    }
}
