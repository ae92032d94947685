package simgsm.cells.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.function.Consumer;
import simgsm.console.HostPort;

/** Sends GSMTAP packets to one address over UDP; what cannot be sent at once is dropped. */
public final class GsmtapSocket implements Consumer<byte[]>, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(GsmtapSocket.class.getName());

    /** Not connected: a refusal by a host without a listener would cost the next packet. */
    private final DatagramChannel channel;

    private final InetSocketAddress address;
    private boolean isFailureLogged;

    /** @throws IOException naming an address that does not exist */
    public GsmtapSocket(HostPort receiver) throws IOException {
        address = new InetSocketAddress(receiver.host(), receiver.port());
        if (address.isUnresolved()) {
            throw new IOException("--gsmtap: no host " + receiver.host());
        }
        channel = DatagramChannel.open();
        channel.configureBlocking(false);
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
