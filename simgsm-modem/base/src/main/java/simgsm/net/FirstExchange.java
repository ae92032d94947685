package simgsm.net;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;

/**
 * A program's exchange with its own port before it reports that it is ready. It loads the classes needed by a first
 * client, which is then answered as fast as later ones.
 */
public final class FirstExchange {
    private static final System.Logger LOG = System.getLogger(FirstExchange.class.getName());
    private static final int PATIENCE_MILLIS = 1_000;
    private static final int CHUNK_OCTETS = 8_192;

    private FirstExchange() {}

    /**
     * Connects, sends each request after the answer to the one before, and disconnects; gives up if the port does not
     * answer within 1 s.
     *
     * @param address the port's address
     */
    public static void with(InetAddress address, int port, byte[]... requests) {
        InetAddress near = address.isAnyLocalAddress() ? InetAddress.getLoopbackAddress() : address;
        try (Socket socket = new Socket()) {
            socket.setSoTimeout(PATIENCE_MILLIS);
            socket.connect(new InetSocketAddress(near, port), PATIENCE_MILLIS);
            OutputStream out = socket.getOutputStream();
            InputStream in = socket.getInputStream();
            byte[] answer = new byte[CHUNK_OCTETS];
            for (byte[] request : requests) {
                out.write(request);
                in.read(answer);
            }
            socket.shutdownOutput();
            in.transferTo(OutputStream.nullOutputStream());
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "no first exchange with port " + port + ": " + e.getMessage());
        }
    }
}
