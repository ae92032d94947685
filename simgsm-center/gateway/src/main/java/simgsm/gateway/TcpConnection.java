package simgsm.gateway;

import java.nio.ByteBuffer;
import simgsm.gateway.esme.TcpProtocol;
import simgsm.gateway.esme.TcpSocket;
import simgsm.net.BufferedConnection;

/** A TCP connection of a core: to the SMSC, to the mail server, or of a mail client. */
final class TcpConnection extends BufferedConnection implements TcpSocket {
    private static final int MOST_UNSENT = 1024 * 1024;

    private final CoreTime time;
    private final TcpProtocol protocol;
    private final Runnable closed;

    /** @param closed runs once the socket is closed */
    TcpConnection(Endpoint endpoint, CoreTime time, TcpProtocol protocol, Runnable closed) {
        super(endpoint, MOST_UNSENT, MOST_UNSENT);
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
    protected void lost(String reason) {
        closed.run();
        if (!isEnding()) {
            time.advance();
            protocol.lost(reason);
        }
    }
}
