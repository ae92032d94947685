package simgsm.cells.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Optional;
import java.util.function.Consumer;

/** Sends GSMTAP packets to one address over UDP; what cannot be sent at once is dropped. */
public final class GsmtapSocket implements Consumer<byte[]>, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(GsmtapSocket.class.getName());

    /** Not connected: a refusal by a host without a listener would cost the next packet. */
    private final DatagramChannel channel;

    private final InetSocketAddress address;
    private boolean isFailureLogged;

    private GsmtapSocket(InetSocketAddress address) throws IOException {
        this.address = address;
        channel = DatagramChannel.open();
        channel.configureBlocking(false);
    }

    /** The socket to a receiver; null for none. @throws IOException naming a host that does not exist */
    public static GsmtapSocket to(Optional<InetSocketAddress> receiver) throws IOException {
        if (receiver.filter(InetSocketAddress::isUnresolved).isPresent()) {
            throw new IOException("--gsmtap: no host " + receiver.get().getHostString());
        }
        return receiver.isPresent() ? new GsmtapSocket(receiver.get()) : null;
    }

    @Override
    public void accept(byte[] packet) {
        try {
            channel.send(ByteBuffer.wrap(packet), address);
        } catch (IOException e) {
            LOG.log(isFailureLogged ? Level.DEBUG : Level.INFO, "GSMTAP not sent: {0}", e.getMessage());
            isFailureLogged = true;
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
