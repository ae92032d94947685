package simgsm.abis;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.net.Datagrams;
import simgsm.timer.RateLimit;

/** One UDP socket for RTP in addition to a connection, to the peer's host only. */
final class MediaSocket implements MediaPort {
    /** Datagrams of speech: twice a call's rate. */
    private static final int MEDIA_PER_SECOND = 100;
    /** The speech sent by a peer at once after a stall of 4 s. */
    private static final int MEDIA_BURST = 200;

    private static final System.Logger LOG = System.getLogger(IpaConnection.class.getName());

    private final IpaConnection connection;
    private final Consumer<byte[]> received;
    private final RateLimit rate = new RateLimit(MEDIA_PER_SECOND, MEDIA_BURST);
    /** Null if closed. */
    private Datagrams socket;

    private int peerPort;

    MediaSocket(IpaConnection connection, Consumer<byte[]> received) {
        this.connection = connection;
        this.received = received;
    }

    boolean isClosed() {
        return socket == null;
    }

    @Override
    public Optional<MediaAddress> openMedia() {
        closeMedia();
        try {
            socket = connection.datagrams(this::arrived);
            return Optional.of(
                    new MediaAddress(socket.localAddress().getAddress().getHostAddress(), ownPort()));
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: no RTP over UDP, {1}", connection.address(), e.getMessage());
            return Optional.empty();
        }
    }

    private int ownPort() {
        return socket.localAddress().getPort();
    }

    @Override
    public boolean connectMedia(MediaAddress peer) {
        InetAddress host = connection.address().getAddress();
        if (socket == null || peer.port() == 0 || !peer.host().equals(host.getHostAddress())) {
            return false;
        }
        try {
            socket.connect(new InetSocketAddress(host, peer.port()));
            peerPort = peer.port();
            return true;
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: no RTP over UDP, {1}", connection.address(), e.getMessage());
            return false;
        }
    }

    @Override
    public boolean sendMedia(byte[] rtp) {
        boolean isSent = socket != null && socket.send(rtp);
        if (isSent) {
            connection.mediaPassed(false, peerPort, ownPort(), rtp);
        }
        return isSent;
    }

    private void arrived(byte[] rtp) {
        if (connection.isOpen()
                && socket != null
                && rtp.length <= IpaFrame.MAX_PAYLOAD
                && rate.take(System.nanoTime())) {
            connection.mediaPassed(true, peerPort, ownPort(), rtp);
            received.accept(rtp);
        }
    }

    @Override
    public void closeMedia() {
        if (socket != null) {
            socket.close();
            socket = null;
        }
    }
}
