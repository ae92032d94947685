package simgsm.net;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.channels.ByteChannel;
import java.nio.channels.FileChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Address of a robot or a modem: {@code HOST:PORT}, or the device file of a serial line with its speed already set. */
public sealed interface LineAddress extends ByteLine {
    /** A TCP port. */
    record Tcp(String host, int port) implements LineAddress {
        private static final int PATIENCE_MILLIS = 5000;

        /** Connects through the socket, because {@link SocketChannel#connect} has no timeout. */
        @Override
        public ByteChannel open() throws IOException {
            SocketChannel channel = SocketChannel.open();
            try {
                InetSocketAddress address = new InetSocketAddress(host, port);
                if (address.isUnresolved()) {
                    throw new UnknownHostException("unknown host " + host);
                }
                channel.socket().connect(address, PATIENCE_MILLIS);
                channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
                return channel;
            } catch (IOException | RuntimeException e) {
                channel.close();
                throw e;
            }
        }

        @Override
        public String toString() {
            return (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + port;
        }
    }

    /** A device opened twice: within one file channel a blocked read delays writes. */
    record TwoWay(FileChannel in, FileChannel out) implements ByteChannel {
        @Override
        public int read(ByteBuffer buffer) throws IOException {
            return in.read(buffer);
        }

        @Override
        public int write(ByteBuffer buffer) throws IOException {
            return out.write(buffer);
        }

        @Override
        public boolean isOpen() {
            return in.isOpen();
        }

        @Override
        public void close() throws IOException {
            try (in) {
                out.close();
            }
        }
    }

    /** A serial line. */
    record Device(Path file) implements LineAddress {
        @Override
        public ByteChannel open() throws IOException {
            FileChannel in = FileChannel.open(file, StandardOpenOption.READ);
            try {
                return new TwoWay(in, FileChannel.open(file, StandardOpenOption.WRITE));
            } catch (IOException | RuntimeException e) {
                in.close();
                throw e;
            }
        }

        @Override
        public String toString() {
            return file.toString();
        }
    }

    /** A TCP port; texts put an IPv6 address in brackets. */
    static LineAddress of(InetSocketAddress address) {
        return new Tcp(address.getHostString(), address.getPort());
    }

    /** @throws IllegalArgumentException if the text is no address; the message names the expected form */
    static LineAddress parse(String text) {
        int colon = text.lastIndexOf(':');
        if (colon > 0 && text.substring(colon + 1).matches("[0-9]{1,5}")) {
            int port = Integer.parseInt(text.substring(colon + 1));
            String host = text.substring(0, colon);
            boolean isBracketed = host.startsWith("[") && host.endsWith("]");
            if (port >= 1 && port <= 0xFFFF && (isBracketed || host.indexOf(':') < 0)) {
                return new Tcp(isBracketed ? host.substring(1, host.length() - 1) : host, port);
            }
        }
        String found = text;
        try {
            Path file = Path.of(text);
            if (Files.isRegularFile(file)) {
                found += ", a regular file, which would be overwritten";
            } else if (!text.isEmpty() && Files.exists(file) && !Files.isDirectory(file)) {
                return new Device(file);
            }
        } catch (InvalidPathException e) {
            // reported below
        }
        throw new IllegalArgumentException("expected HOST:PORT or a serial line's device file, found " + found);
    }
}
