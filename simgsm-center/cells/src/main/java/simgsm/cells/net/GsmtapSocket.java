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

    private final DatagramChannel channel;
    private boolean isFailureLogged;

    /** @throws IOException naming an address that does not exist */
    public GsmtapSocket(HostPort receiver) throws IOException {
        InetSocketAddress address = new InetSocketAddress(receiver.host(), receiver.port());
        if (address.isUnresolved()) {
            throw new IOException("--gsmtap: no host " + receiver.host());
        }
        channel = DatagramChannel.open();
        channel.configureBlocking(false);
        channel.connect(address);
    }

    @Override
    public void accept(byte[] packet) {
        try {
            channel.write(ByteBuffer.wrap(packet));
        } catch (IOException e) {
            // loopback reports that nobody listens
            LOG.log(isFailureLogged ? Level.DEBUG : Level.INFO, "no GSMTAP receiver: {0}", e.getMessage());
            isFailureLogged = true;
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
