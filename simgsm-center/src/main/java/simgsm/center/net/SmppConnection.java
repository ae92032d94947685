package simgsm.center.net;

import java.nio.ByteBuffer;
import simgsm.center.smpp.EsmeSession;
import simgsm.center.smpp.SmppPort;
import simgsm.center.smpp.SmppServer;
import simgsm.net.BufferedConnection;
import simgsm.net.ConnectionLimits;

/** One application's connection to the exchange. */
final class SmppConnection extends BufferedConnection implements SmppPort {
    /** Unsent octets above which nothing is read. */
    static final int ENOUGH_UNSENT = 256 * 1024;
    /** Unsent octets above which the peer is disconnected. */
    static final int TOO_MUCH_UNSENT = 8 * 1024 * 1024;

    /** Limit per iteration of a remote peer: 100 to 200 PDUs. */
    private static final int REMOTE_READ_LIMIT = 4 * 1024;

    private final CenterLoop center;
    private final SmppServer smpp;
    private final ConnectionLimits places;
    private EsmeSession session;

    SmppConnection(Endpoint endpoint, CenterLoop center, SmppServer smpp, ConnectionLimits places) {
        super(endpoint, ENOUGH_UNSENT, TOO_MUCH_UNSENT);
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
    public void bound() {
        places.proven(address().getAddress());
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
