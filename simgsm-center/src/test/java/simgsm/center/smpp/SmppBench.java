package simgsm.center.smpp;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;

/**
 * Measures a centre from outside: senders with a window each hand messages in, one receiver takes them. Prints one line:
 * messages a second from submit_sm to deliver_sm_resp, and the time from one to the other. One thread and headers only, so
 * that the centre is what is measured.
 *
 * <pre>
 *   java -jar target/dist/simgsm-center.jar --headless --port 0 --smpp 2775
 *   java -cp simgsm-center/target/test-classes:target/dist/simgsm-center.jar:target/dist/simgsm-modem.jar \
 *       simgsm.center.smpp.SmppBench [HOST] [PORT] [SENDERS] [WINDOW] [SECONDS] [IDLE SESSIONS]
 * </pre>
 */
public final class SmppBench {
    private static final String NUMBER = "5550300";
    private static final int WARM_UP_SECONDS = 5;
    /** The user_message_reference behind the text of deliver_sm. */
    private static final int REFERENCE_LENGTH = 6;

    private static final int SUBMIT_RESPONSE = 0x8000_0004;
    private static final int DELIVER = 5;
    private static final int MAX_SAMPLES = 4_000_000;
    /** Where the time stands in a submit_sm of ours: in the last 16 of its octets. */
    private static final int STAMP_LENGTH = 16;

    private final Selector selector;
    private final int window;
    private final long[] latencies = new long[MAX_SAMPLES];
    private int samples;
    private long delivered;
    private long refused;
    private boolean isSending = true;

    private final class Client {
        final SocketChannel channel;
        final ByteBuffer in = ByteBuffer.allocate(256 * 1024);
        final ByteBuffer out = ByteBuffer.allocate(256 * 1024);
        final byte[] submit;
        int outstanding;
        int sequence = 1;

        Client(InetSocketAddress address, SmppCommand command, String id, String range, byte[] submit)
                throws IOException {
            this.submit = submit;
            channel = SocketChannel.open(address);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            channel.write(
                    ByteBuffer.wrap(SmppCodec.encode(new SmppPdu.Bind(command, sequence++, id, "", "", 0x34, range))));
            while (in.position() < 4 || in.position() < in.getInt(0)) {
                channel.read(in);
            }
            if (in.getInt(8) != 0) {
                throw new IOException("bind answered with status " + in.getInt(8));
            }
            channel.configureBlocking(false);
            // What an earlier run left waiting may have come with the answer to bind: it is to be answered, too.
            in.flip().position(in.getInt(0));
            takeAll();
            channel.register(selector, SelectionKey.OP_READ | SelectionKey.OP_WRITE, this);
        }

        void fill() {
            while (isSending && submit != null && outstanding < window && out.remaining() > submit.length) {
                int at = out.position();
                out.put(submit);
                out.putInt(at + 12, sequence++ & Integer.MAX_VALUE);
                putStamp(out, at + submit.length - STAMP_LENGTH, System.nanoTime());
                outstanding++;
            }
        }

        void read() throws IOException {
            if (channel.read(in) < 0) {
                throw new IOException("the centre has closed the connection");
            }
            in.flip();
            takeAll();
        }

        private void takeAll() {
            while (in.remaining() >= 4 && in.remaining() >= in.getInt(in.position())) {
                int at = in.position();
                int length = in.getInt(at);
                take(at, length);
                in.position(at + length);
            }
            in.compact();
        }

        private void take(int at, int length) {
            int command = in.getInt(at + 4);
            if (command == SUBMIT_RESPONSE) {
                outstanding--;
                refused += in.getInt(at + 8) == 0 ? 0 : 1;
            } else if (command == DELIVER) {
                out.putInt(17).putInt(DELIVER | SmppCommand.RESPONSE).putInt(0).putInt(in.getInt(at + 12));
                out.put((byte) 0);
                delivered++;
                if (samples < MAX_SAMPLES) {
                    latencies[samples++] = System.nanoTime() - stamp(in, at + length - REFERENCE_LENGTH - STAMP_LENGTH);
                }
            }
        }

        void write() throws IOException {
            out.flip();
            channel.write(out);
            out.compact();
            int wanted = SelectionKey.OP_READ | (out.position() > 0 ? SelectionKey.OP_WRITE : 0);
            channel.keyFor(selector).interestOps(wanted);
        }
    }

    private SmppBench(int window) throws IOException {
        this.window = window;
        selector = Selector.open();
    }

    private static void putStamp(ByteBuffer out, int at, long nanos) {
        for (int i = 0; i < STAMP_LENGTH; i++) {
            out.put(at + i, (byte) ('A' + (nanos >> 4 * i & 0x0f)));
        }
    }

    private static long stamp(ByteBuffer in, int at) {
        long nanos = 0;
        for (int i = STAMP_LENGTH - 1; i >= 0; i--) {
            nanos = nanos << 4 | in.get(at + i) - 'A';
        }
        return nanos;
    }

    private static byte[] submit() {
        String text = "The quick brown fox jumps over the lazy dog " + "A".repeat(STAMP_LENGTH);
        SmppMessage message = SmppMessage.of(
                new SmppAddress(1, 1, "5550100"),
                new SmppAddress(1, 1, NUMBER),
                0,
                0,
                0,
                simgsm.octets.OctetString.of(text.getBytes(StandardCharsets.US_ASCII)),
                List.of());
        return SmppCodec.encode(new SmppPdu.Message(SmppCommand.SUBMIT_SM, 0, message));
    }

    private void runUntil(long endNanos, List<Client> senders) throws IOException {
        while (System.nanoTime() < endNanos) {
            for (Client sender : senders) {
                sender.fill();
                if (sender.out.position() > 0) {
                    sender.write();
                }
            }
            selector.select(
                    key -> {
                        Client client = (Client) key.attachment();
                        try {
                            if (key.isReadable()) {
                                client.read();
                            }
                            client.write();
                        } catch (IOException e) {
                            throw new java.io.UncheckedIOException(e);
                        }
                    },
                    100);
        }
    }

    private static int argument(String[] args, int index, int otherwise) {
        return args.length > index ? Integer.parseInt(args[index]) : otherwise;
    }

    public static void main(String[] args) throws IOException {
        String host = args.length > 0 ? args[0] : "127.0.0.1";
        InetSocketAddress address = new InetSocketAddress(host, argument(args, 1, 2775));
        int senders = argument(args, 2, 4);
        SmppBench bench = new SmppBench(argument(args, 3, 25));
        int seconds = argument(args, 4, 20);
        int idle = argument(args, 5, 0);
        for (int i = 0; i < idle; i++) {
            bench.new Client(address, SmppCommand.BIND_TRANSCEIVER, "idle" + i, "" + (7_000_000 + i), null);
        }
        bench.new Client(address, SmppCommand.BIND_RECEIVER, "receiver", NUMBER, null);
        List<Client> clients = new ArrayList<>();
        for (int i = 0; i < senders; i++) {
            clients.add(bench.new Client(address, SmppCommand.BIND_TRANSMITTER, "sender" + i, "", submit()));
        }
        bench.runUntil(System.nanoTime() + WARM_UP_SECONDS * 1_000_000_000L, clients);
        bench.samples = 0;
        long before = bench.delivered;
        long start = System.nanoTime();
        bench.runUntil(start + seconds * 1_000_000_000L, clients);
        double elapsed = (System.nanoTime() - start) / 1e9;
        long count = bench.delivered - before;
        Arrays.sort(bench.latencies, 0, bench.samples);
        System.out.printf(
                "senders=%d window=%d sessions=%d messages=%d refused=%d per-second=%.0f p50-ms=%.2f p99-ms=%.2f%n",
                senders,
                bench.window,
                idle + senders + 1,
                count,
                bench.refused,
                count / elapsed,
                bench.latencies[bench.samples / 2] / 1e6,
                bench.latencies[(int) (bench.samples * 0.99)] / 1e6);
    }
}
