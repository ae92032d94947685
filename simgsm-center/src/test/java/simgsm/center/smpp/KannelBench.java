package simgsm.center.smpp;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.stream.Stream;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;

/**
 * Measures store and forward from SMPP to SMPP side by side: a Kannel bearerbox (file store, without fsync), which connects
 * to both ends as to two SMSCs, and this centre (journal with fsync), to which both ends connect. One sender with a window
 * of 100, one receiver, the same messages. Prints a line each: rate and CPU seconds of the program measured.
 *
 * <pre>
 *   java -cp simgsm-center/target/test-classes:target/dist/simgsm-center.jar:target/dist/simgsm-modem.jar \
 *       simgsm.center.smpp.KannelBench [MESSAGES] [ROUNDS]
 * </pre>
 */
public final class KannelBench {
    private static final int WINDOW = 100;
    /** Longer than a bearerbox needs to connect. */
    private static final int PATIENCE_MILLIS = 30_000;

    private static final String NUMBER = "5550300";

    private final Semaphore window = new Semaphore(WINDOW);
    private final Semaphore arrived = new Semaphore(0);
    private final Peer sender;
    private final Peer receiver;
    private final SmppCommand sending;

    /** One end of the way: a socket on which PDUs are read and answered. */
    private static final class Peer {
        final DataInputStream in;
        final OutputStream out;

        Peer(Socket socket) throws IOException {
            socket.setTcpNoDelay(true);
            in = new DataInputStream(new BufferedInputStream(socket.getInputStream(), 1 << 16));
            out = new BufferedOutputStream(socket.getOutputStream(), 1 << 16);
        }

        void send(SmppPdu pdu) throws IOException {
            synchronized (out) {
                out.write(SmppCodec.encode(pdu));
            }
        }

        void flush() throws IOException {
            synchronized (out) {
                out.flush();
            }
        }

        SmppPdu read() throws IOException, SmppViolation {
            int length = in.readInt();
            byte[] octets = new byte[length];
            in.readFully(octets, 4, length - 4);
            return SmppCodec.decode(octets);
        }
    }

    private KannelBench(Peer sender, Peer receiver, SmppCommand sending) {
        this.sender = sender;
        this.receiver = receiver;
        this.sending = sending;
        serve(sender);
        serve(receiver);
    }

    public static void main(String[] args) throws Exception {
        int messages = args.length > 0 ? Integer.parseInt(args[0]) : 30_000;
        int rounds = args.length > 1 ? Integer.parseInt(args[1]) : 2;
        Path folder = Files.createTempDirectory("kannel-bench");
        try {
            kannel(folder, messages, rounds);
            centre(folder, messages, rounds);
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                files.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
            }
        }
    }

    private static void kannel(Path folder, int messages, int rounds) throws Exception {
        try (ServerSocket from = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                ServerSocket to = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Path configuration = Files.writeString(folder.resolve("kannel.conf"), """
                    group = core
                    admin-port = %d
                    admin-password = x
                    smsbox-port = %d
                    log-file = %s
                    log-level = 3
                    store-type = file
                    store-location = %s
                    %s%s

                    group = smsbox
                    bearerbox-host = 127.0.0.1
                    sendsms-port = %d

                    group = sendsms-user
                    username = x
                    password = x
                    """.formatted(
                            freePort(),
                            freePort(),
                            folder.resolve("kannel.log"),
                            folder.resolve("kannel.store"),
                            smsc("from", from.getLocalPort(), "reroute-smsc-id = to\n"),
                            smsc("to", to.getLocalPort(), ""),
                            freePort()));
            Process box = new ProcessBuilder("bearerbox", configuration.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(folder.resolve("bearerbox.out").toFile())
                    .start();
            from.setSoTimeout(PATIENCE_MILLIS);
            to.setSoTimeout(PATIENCE_MILLIS);
            try {
                KannelBench bench =
                        new KannelBench(new Peer(from.accept()), new Peer(to.accept()), SmppCommand.DELIVER_SM);
                bench.measure("kannel", box.toHandle(), messages, rounds);
            } finally {
                box.destroyForcibly();
            }
        }
    }

    private static String smsc(String name, int port, String more) {
        return """

                group = smsc
                smsc = smpp
                smsc-id = %s
                host = 127.0.0.1
                port = %d
                transceiver-mode = true
                smsc-username = kannel
                smsc-password = kannel
                system-type = ""
                max-pending-submits = %d
                %s""".formatted(name, port, WINDOW, more);
    }

    private static void centre(Path folder, int messages, int rounds) throws Exception {
        Process centre = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-jar",
                        "target/dist/simgsm-center.jar",
                        "--headless",
                        "--port",
                        "0",
                        "--smpp",
                        "0",
                        "--data",
                        folder.resolve("centre").toString())
                .redirectError(folder.resolve("centre.err").toFile())
                .start();
        try {
            BufferedReader events =
                    new BufferedReader(new InputStreamReader(centre.getInputStream(), StandardCharsets.UTF_8));
            String ready = events.readLine();
            Thread drain = new Thread(() -> events.lines().forEach(line -> {}), "events");
            drain.setDaemon(true);
            drain.start();
            int port = Integer.parseInt(ready.replaceAll(".* smpp=", ""));
            Peer receiver = bound(port, SmppCommand.BIND_RECEIVER, NUMBER);
            Peer sender = bound(port, SmppCommand.BIND_TRANSMITTER, "");
            new KannelBench(sender, receiver, SmppCommand.SUBMIT_SM)
                    .measure("simgsm", centre.toHandle(), messages, rounds);
        } finally {
            centre.destroy();
        }
    }

    private static Peer bound(int port, SmppCommand command, String range) throws IOException, SmppViolation {
        Peer peer = new Peer(new Socket(InetAddress.getLoopbackAddress(), port));
        peer.send(new SmppPdu.Bind(command, 1, "bench", "", "", 0x34, range));
        peer.flush();
        peer.read();
        return peer;
    }

    private static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }

    private void serve(Peer peer) {
        Thread reader = new Thread(
                () -> {
                    try {
                        while (true) {
                            SmppPdu pdu = peer.read();
                            take(peer, pdu);
                            if (peer.in.available() == 0) {
                                peer.flush();
                            }
                        }
                    } catch (IOException | SmppViolation ended) {
                        System.err.println("an end is closed: " + ended.getMessage());
                    }
                },
                "end");
        reader.setDaemon(true);
        reader.start();
    }

    private void take(Peer peer, SmppPdu pdu) throws IOException {
        if (pdu instanceof SmppPdu.Bind bind) {
            peer.send(new SmppPdu.BindResponse(bind.command(), SmppStatus.OK, bind.sequence(), "bench"));
        } else if (pdu instanceof SmppPdu.Plain plain) {
            peer.send(new SmppPdu.PlainResponse(plain.command(), SmppStatus.OK, plain.sequence()));
        } else if (pdu instanceof SmppPdu.Message message) {
            peer.send(new SmppPdu.MessageResponse(
                    message.command(), SmppStatus.OK, message.sequence(), String.valueOf(message.sequence())));
            arrived.release();
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            if (response.status() != SmppStatus.OK) {
                throw new IOException("refused with status " + response.status());
            }
            window.release();
        }
    }

    private void measure(String name, ProcessHandle program, int messages, int rounds) throws Exception {
        int sequence = 0;
        for (int round = 0; round <= rounds; round++) {
            Duration cpu = program.info().totalCpuDuration().orElse(Duration.ZERO);
            long start = System.nanoTime();
            for (int i = 0; i < messages; i++) {
                if (!window.tryAcquire()) {
                    sender.flush();
                    window.acquire();
                }
                sender.send(new SmppPdu.Message(sending, ++sequence, message(sequence)));
            }
            sender.flush();
            arrived.acquire(messages);
            double seconds = (System.nanoTime() - start) / 1e9;
            double used = program.info()
                            .totalCpuDuration()
                            .orElse(Duration.ZERO)
                            .minus(cpu)
                            .toMillis()
                    / 1e3;
            System.out.printf(
                    "%s round=%d messages=%d seconds=%.2f rate=%.0f cpu=%.2f msCpuEach=%.4f%n",
                    name, round, messages, seconds, messages / seconds, used, used * 1_000 / messages);
        }
    }

    private static SmppMessage message(int number) {
        return SmppMessage.of(
                new SmppAddress(1, 1, "5550100"),
                new SmppAddress(1, 1, NUMBER),
                0,
                0,
                0,
                OctetString.of(("message " + number + " of the bench, about fifty octets long")
                        .getBytes(StandardCharsets.US_ASCII)),
                List.of());
    }
}
