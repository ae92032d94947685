package simgsm.center.net;

import java.nio.ByteBuffer;

/** One accepted connection, as the loop sees it. */
interface Peer {
    /** What a connection asks of its loop. */
    interface Host {
        /** The connection cannot go on; the loop closes it once the exchange is at rest. */
        void broken(Peer peer, String reason);

        /** The socket is closed, by whomever. */
        void closed(Peer peer);
    }

    boolean isOpen();

    /** Reads once, so that a busy peer does not keep the others waiting. */
    void readable(ByteBuffer buffer);

    void writable();

    /** Closes the socket; once is enough. */
    void shut();

    /** The exchange is to forget it. */
    void lost(String reason);
}
