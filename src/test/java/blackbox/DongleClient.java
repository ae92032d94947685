package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.PcmFrames;

/**
 * Asterisk's chan_dongle as a modem sees it, by its source: the order of its commands, which answers it needs, how it
 * reads them, and the sound on a second line, where each frame that it reads lets it write one.
 */
final class DongleClient implements AutoCloseable {
    /** Sent at the start; after an error of one with a minus it goes on. */
    private static final List<String> INITIALISATION = List.of(
            "AT",
            "ATZ",
            "ATE0",
            "-AT^U2DIAG=0",
            "AT+CGMI",
            "AT+CGMM",
            "AT+CGMR",
            "AT+CMEE=0",
            "AT+CGSN",
            "AT+CIMI",
            "AT+CPIN?",
            "AT+COPS=0,0",
            "AT+CREG=2",
            "AT+CREG?",
            "-AT+CNUM",
            "AT^CVOICE?",
            "AT+CSCA?",
            "AT+CSSN=1,1",
            "AT+CMGF=0",
            "AT+CPMS=\"SM\",\"SM\",\"SM\"",
            "AT+CNMI=2,1,0,2,0",
            "AT+CSQ");

    /** It reads the lists of some commands as one piece that ends so. */
    private static final Pattern CALL =
            Pattern.compile("\\+CLCC: ?(\\d),(\\d),(\\d),0,\\d,\"([^\"]*)\",(\\d+)\r\n\r\nOK\r\n");

    private final Socket commands;
    private final Socket sound;
    private final StringBuilder input = new StringBuilder();
    private final StringBuilder all = new StringBuilder();
    private int codesRead;
    private final StringBuffer keysHeard = new StringBuffer();
    private final DtmfGenerator caller = new DtmfGenerator();
    private final Thread listener = new Thread(this::listen, "sound of the dongle");
    private volatile int framesRead;

    DongleClient(RunningProgram program) throws IOException {
        ConsoleEvent ready = program.said("ready");
        commands = connect(ready.field("at"));
        sound = connect(ready.field("at-audio"));
        listener.setDaemon(true);
        listener.start();
    }

    private static Socket connect(String port) throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), Integer.parseInt(port));
        socket.setTcpNoDelay(true);
        socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
        return socket;
    }

    // ---- sound -----------------------------------------------------------------------------------------------------

    private void listen() {
        DtmfReceiver receiver =
                new DtmfReceiver(digit -> keysHeard.append(digit.key().symbol()));
        byte[] octets = new byte[PcmFrames.OCTETS];
        short[] frame = new short[PcmFrames.OCTETS / 2];
        try {
            sound.setSoTimeout(0);
            DataInputStream in = new DataInputStream(sound.getInputStream());
            while (true) {
                in.readFully(octets);
                ByteBuffer.wrap(octets)
                        .order(ByteOrder.LITTLE_ENDIAN)
                        .asShortBuffer()
                        .get(frame);
                receiver.accept(frame);
                synchronized (caller) {
                    caller.read(frame);
                }
                sound.getOutputStream().write(PcmFrames.octets(frame));
                framesRead++;
            }
        } catch (IOException ended) {
            // closed below
        }
    }

    /** Keys of the telephone that Asterisk has connected, as sound. */
    void press(String keys) {
        synchronized (caller) {
            DtmfKey.sequence(keys.replace(" ", "")).forEach(key -> caller.enqueue(key, 100, 100));
        }
    }

    String keysHeard() {
        return keysHeard.toString();
    }

    int framesRead() {
        return framesRead;
    }

    // ---- commands --------------------------------------------------------------------------------------------------

    void initialise() throws IOException {
        for (String each : INITIALISATION) {
            boolean isNeeded = !each.startsWith("-");
            String answer = say(isNeeded ? each : each.substring(1), "OK|ERROR");
            assertTrue(answer.endsWith("OK\r\n") || !isNeeded, each + ": " + answer);
            if (each.equals("AT^CVOICE?")) {
                assertTrue(answer.contains("\r\n^CVOICE:"), answer);
            }
        }
    }

    /** It tells the calls apart by the list after the command. @return the state of the call */
    int call(String number) throws IOException {
        ok("ATD" + number + ";");
        int state = listCall("0", number);
        ok("AT^DDSETEX=2");
        return state;
    }

    /** A call that RING has announced. */
    void answer(String from) throws IOException {
        code("RING");
        assertEquals(4, listCall("1", from));
        ok("ATA");
        ok("AT^DDSETEX=2");
    }

    private int listCall(String direction, String number) throws IOException {
        send("AT+CLCC");
        Matcher list = await(CALL);
        assertEquals(
                List.of("1", direction, number),
                List.of(list.group(1), list.group(2), list.group(4).replace("+", "")));
        return Integer.parseInt(list.group(3));
    }

    /** The text of a stored message's PDU follows in the answer. */
    String readMessage() throws IOException {
        Matcher notice = await(Pattern.compile("\\+CMTI: \"SM\",(\\d+)\r\n"));
        String answer = ok("AT+CMGR=" + notice.group(1));
        ok("AT+CMGD=" + notice.group(1));
        return answer;
    }

    void submit(String pdu) throws IOException {
        send("AT+CMGS=" + (pdu.length() / 2 - 1));
        await("> ");
        commands.getOutputStream().write((pdu + "\u001a").getBytes(StandardCharsets.US_ASCII));
        await("\r\nOK\r\n");
    }

    String ok(String command) throws IOException {
        return say(command, "OK");
    }

    private String say(String command, String result) throws IOException {
        send(command);
        return await(Pattern.compile("\r\n(?:" + result + ")\r\n")).group();
    }

    void send(String command) throws IOException {
        commands.getOutputStream().write((command + "\r").getBytes(StandardCharsets.US_ASCII));
    }

    private void await(String text) throws IOException {
        await(Pattern.compile(Pattern.quote(text)));
    }

    /** An unsolicited code, which may have come before the answer read last. */
    void code(String pattern) throws IOException {
        Matcher matcher = Pattern.compile("\r\n" + pattern + "\r\n").matcher(all);
        while (!matcher.find(codesRead)) {
            read();
            matcher.reset(all);
        }
        codesRead = matcher.end();
    }

    /** Reads to the end of the match; the match has all that was read with it. */
    private Matcher await(Pattern wanted) throws IOException {
        Pattern withBefore = Pattern.compile("(?s:.*?)" + wanted);
        while (true) {
            Matcher matcher = withBefore.matcher(input.toString());
            if (matcher.lookingAt()) {
                input.delete(0, matcher.end());
                return matcher;
            }
            read();
        }
    }

    private void read() throws IOException {
        byte[] buffer = new byte[1024];
        int count = commands.getInputStream().read(buffer);
        assertTrue(count > 0, () -> "the modem has ended after " + all);
        String text = new String(buffer, 0, count, StandardCharsets.ISO_8859_1);
        input.append(text);
        all.append(text);
    }

    @Override
    public void close() throws IOException {
        commands.close();
        sound.close();
    }
}
