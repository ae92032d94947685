package simgsm.center.smpp;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.StationThread;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;

/**
 * Measures a centre from outside: an application hands messages in by SMPP, real stations over TCP take them with all of
 * the CP and RP dialogue, and only what a station has shown counts. A window of messages is under way at a time. Prints one line.
 *
 * <pre>
 *   java -jar target/dist/simgsm-center.jar --headless --port 3003 --smpp 2775
 *   java -cp simgsm-center/target/test-classes:target/dist/simgsm-center.jar:target/dist/simgsm-modem.jar \
 *       simgsm.center.smpp.SmppToPhonesBench [PORT] [SMPP PORT] [PHONES] [UNDER WAY] [SECONDS] 2>log
 * </pre>
 */
public final class SmppToPhonesBench {
    private static final String HOST = "127.0.0.1";
    private static final long FIRST_NUMBER = 7_000_000;
    private static final int WARM_UP_SECONDS = 5;
    private static final int MAX_SAMPLES = 4_000_000;
    private static final int STAMP_LENGTH = 16;
    /** Where a PDU without its length has its status. */
    private static final int STATUS = 4;

    private final Semaphore room;
    private final CountDownLatch attached;
    private final long[] latencies = new long[MAX_SAMPLES];
    private volatile int shown;

    private SmppToPhonesBench(int phones, int underWay) {
        attached = new CountDownLatch(phones);
        room = new Semaphore(underWay);
    }

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.StationRegistered) {
            attached.countDown();
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            int count = shown;
            if (count < MAX_SAMPLES) {
                String stamp = message.text().substring(message.text().length() - STAMP_LENGTH);
                latencies[count] = System.nanoTime() - Long.parseLong(stamp, Character.MAX_RADIX);
            }
            shown = count + 1;
            room.release();
        }
    }

    private void attach(StationThread thread, int phones, int port) throws InterruptedException {
        thread.start();
        for (int i = 0; i < phones; i++) {
            StationIdentity identity = StationIdentity.ofOpenNumber(
                    new Msisdn(String.valueOf(FIRST_NUMBER + i)), Imei.of("00101752", i), "SimGSM bench");
            thread.add(
                    new MobileStation(
                            identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, SpeechSource.SILENCE, this::accept),
                    new InetSocketAddress(HOST, port));
        }
        attached.await();
    }

    private void submit(int smppPort, int phones) throws IOException, InterruptedException {
        try (Socket socket = new Socket(HOST, smppPort)) {
            socket.setTcpNoDelay(true);
            OutputStream out = new BufferedOutputStream(socket.getOutputStream(), 64 * 1024);
            DataInputStream in = new DataInputStream(new BufferedInputStream(socket.getInputStream(), 64 * 1024));
            out.write(SmppCodec.encode(new SmppPdu.Bind(SmppCommand.BIND_TRANSMITTER, 1, "bench", "", "", 0x34, "")));
            out.flush();
            skipPdu(in);
            Thread answers = new Thread(() -> skipAll(in), "answers");
            answers.setDaemon(true);
            answers.start();
            for (int sequence = 2; ; sequence++) {
                if (!room.tryAcquire()) {
                    out.flush();
                    room.acquire();
                }
                out.write(submit(sequence, FIRST_NUMBER + sequence % phones));
            }
        }
    }

    private static void skipAll(DataInputStream in) {
        try {
            while (true) {
                skipPdu(in);
            }
        } catch (IOException e) {
            System.err.println("SMPP: " + e.getMessage());
        }
    }

    private static void skipPdu(DataInputStream in) throws IOException {
        byte[] rest = new byte[in.readInt() - 4];
        in.readFully(rest);
        int status = rest[STATUS] | rest[STATUS + 1] | rest[STATUS + 2] | rest[STATUS + 3];
        if (status != 0) {
            throw new IOException("refused, " + OctetString.of(rest));
        }
    }

    private static byte[] submit(int sequence, long number) {
        String stamp = Long.toString(System.nanoTime(), Character.MAX_RADIX);
        String text =
                "The quick brown fox jumps over the lazy dog " + "0".repeat(STAMP_LENGTH - stamp.length()) + stamp;
        SmppMessage message = SmppMessage.of(
                new SmppAddress(1, 1, "5550100"),
                new SmppAddress(1, 1, String.valueOf(number)),
                0,
                0,
                0,
                OctetString.of(text.getBytes(StandardCharsets.US_ASCII)),
                List.of());
        return SmppCodec.encode(new SmppPdu.Message(SmppCommand.SUBMIT_SM, sequence, message));
    }

    private static int argument(String[] args, int index, int otherwise) {
        return args.length > index ? Integer.parseInt(args[index]) : otherwise;
    }

    public static void main(String[] args) throws InterruptedException {
        int phones = argument(args, 2, 100);
        int underWay = argument(args, 3, 1_000);
        int seconds = argument(args, 4, 20);
        SmppToPhonesBench bench = new SmppToPhonesBench(phones, underWay);
        StationThread stations = new StationThread("stations", cause -> System.exit(1));
        bench.attach(stations, phones, argument(args, 0, 3003));
        Thread sender = new Thread(
                () -> {
                    try {
                        bench.submit(argument(args, 1, 2775), phones);
                    } catch (IOException | InterruptedException e) {
                        System.err.println("sender: " + e.getMessage());
                    }
                },
                "sender");
        sender.setDaemon(true);
        sender.start();
        Thread.sleep(WARM_UP_SECONDS * 1_000L);
        int before = bench.shown;
        long start = System.nanoTime();
        Thread.sleep(seconds * 1_000L);
        int after = Math.min(bench.shown, MAX_SAMPLES);
        double elapsed = (System.nanoTime() - start) / 1e9;
        long[] measured = Arrays.copyOfRange(bench.latencies, before, after);
        Arrays.sort(measured);
        System.out.printf(
                "phones=%d under-way=%d messages=%d per-second=%.0f p50-ms=%.2f p99-ms=%.2f%n",
                phones,
                underWay,
                measured.length,
                measured.length / elapsed,
                measured[measured.length / 2] / 1e6,
                measured[(int) (measured.length * 0.99)] / 1e6);
        System.exit(0);
    }
}
