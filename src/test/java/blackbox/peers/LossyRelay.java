package blackbox.peers;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Stands between one SIP client and the gateway, and loses a part of all datagrams in both directions: it puts ports of
 * its own into the session descriptions, so that the speech passes it, too.
 */
final class LossyRelay implements AutoCloseable {
    private static final Pattern AUDIO = Pattern.compile("m=audio ([0-9]+) ");
    private static final Pattern LENGTH = Pattern.compile("(?i)Content-Length: *[0-9]+");
    private static final Pattern CALL = Pattern.compile("(?mi)^Call-ID: *(\\S+)");

    final AtomicLong passed = new AtomicLong();
    final AtomicLong lost = new AtomicLong();
    private final Selector selector = Selector.open();
    private final double loss;
    private final Random random = new Random(1);
    private final InetSocketAddress gateway;
    private final DatagramChannel toClient = open();
    private final DatagramChannel toGateway = open();
    private InetSocketAddress client;
    private final ByteBuffer buffer = ByteBuffer.allocate(65_536);
    /** By call and side: the relay's socket that the side's port is replaced by, and who sends there. */
    private final Map<String, Side> sides = new HashMap<>();

    private final Thread thread = new Thread(this::run, "lossy relay");

    /** One end of the speech of a call. */
    private static final class Side {
        DatagramChannel socket;
        /** Where this side receives. */
        InetSocketAddress address;

        Side other;
    }

    LossyRelay(int gatewayPort, double loss) throws IOException {
        this.loss = loss;
        gateway = new InetSocketAddress(InetAddress.getLoopbackAddress(), gatewayPort);
        toClient.register(selector, SelectionKey.OP_READ);
        toGateway.register(selector, SelectionKey.OP_READ);
        thread.setDaemon(true);
        thread.start();
    }

    private static DatagramChannel open() throws IOException {
        DatagramChannel channel = DatagramChannel.open();
        channel.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        channel.configureBlocking(false);
        return channel;
    }

    /** Where the client sends SIP. */
    int port() {
        return toClient.socket().getLocalPort();
    }

    private void run() {
        try {
            while (selector.isOpen()) {
                selector.select(this::ready);
            }
        } catch (IOException | RuntimeException e) {
            if (selector.isOpen()) {
                e.printStackTrace(System.out);
                throw new IllegalStateException(e);
            }
        }
    }

    private void ready(SelectionKey key) {
        DatagramChannel from = (DatagramChannel) key.channel();
        try {
            for (buffer.clear(); from.receive(buffer) instanceof InetSocketAddress source; buffer.clear()) {
                buffer.flip();
                if (random.nextDouble() < loss) {
                    lost.incrementAndGet();
                    continue;
                }
                passed.incrementAndGet();
                if (key.attachment() instanceof Side side) {
                    // what arrives here is for this side, from the other one
                    side.other.socket.send(buffer, side.address);
                } else {
                    signalling(from, source);
                }
            }
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private void signalling(DatagramChannel from, InetSocketAddress source) throws IOException {
        boolean isFromClient = from == toClient;
        client = isFromClient ? source : client;
        String message = StandardCharsets.UTF_8.decode(buffer).toString();
        Matcher audio = AUDIO.matcher(message);
        if (audio.find()) {
            message = replaced(message, audio, isFromClient);
        }
        ByteBuffer out = ByteBuffer.wrap(message.getBytes(StandardCharsets.UTF_8));
        (isFromClient ? toGateway : toClient).send(out, isFromClient ? gateway : client);
    }

    private String replaced(String message, Matcher audio, boolean isFromClient) throws IOException {
        Matcher call = CALL.matcher(message);
        call.find();
        Side own = side(call.group(1) + isFromClient);
        Side other = side(call.group(1) + !isFromClient);
        own.other = other;
        other.other = own;
        own.address = new InetSocketAddress(InetAddress.getLoopbackAddress(), Integer.parseInt(audio.group(1)));
        String text = audio.replaceFirst("m=audio " + own.socket.socket().getLocalPort() + " ");
        int bodyLength = text.length() - text.indexOf("\r\n\r\n") - 4;
        return LENGTH.matcher(text).replaceFirst("Content-Length: " + bodyLength);
    }

    private Side side(String name) throws IOException {
        Side side = sides.get(name);
        if (side == null) {
            side = new Side();
            side.socket = open();
            side.socket.register(selector, SelectionKey.OP_READ, side);
            sides.put(name, side);
        }
        return side;
    }

    @Override
    public void close() throws IOException {
        selector.close();
        toClient.close();
        toGateway.close();
        for (Side side : sides.values()) {
            side.socket.close();
        }
    }
}
