package blackbox;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Consumer;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.MessageSplitter;
import simgsm.sms.SmsAddress;
import simgsm.sms.TpduCodec;

/**
 * A SIM800, or a modem of another family, as a client sees it, with the faults that such modems and their lines have. It
 * answers 20 ms after a command; its time is moved by hand.
 */
public final class EmulatedModem {
    /** How it reports keys. */
    enum Family {
        SIM800("SIMCOM_Ltd", "AT+DDET=", "+DTMF: %c", 0),
        SIM7600("SIMCOM INCORPORATED", "AT+DDET=", "+RXDTMF: %c", 0),
        TELIT("Telit", "AT#DTMF=1", "#DTMFEV: %c,1", 0),
        QUECTEL("Quectel", "AT+QTONEDET=1", "+QTONEDET: %d", 1),
        U_BLOX("u-blox", "AT+UDTMFD=1", "+UUDTMFD: %c", 0);

        final String manufacturer;
        private final String enabler;
        private final String report;
        private final int ascii;

        Family(String manufacturer, String enabler, String report, int ascii) {
            this.manufacturer = manufacturer;
            this.enabler = enabler;
            this.report = report;
            this.ascii = ascii;
        }

        String report(char key) {
            return ascii == 1 ? String.format(Locale.ROOT, report, (int) key) : String.format(Locale.ROOT, report, key);
        }
    }

    private static final long MILLI = 1_000_000;
    private static final long ANSWER_NANOS = 20 * MILLI;

    private record Due(long atNanos, byte[] octets) {}

    private final Family family;
    private final Consumer<byte[]> toHost;
    private final Deque<Due> due = new ArrayDeque<>();
    private final Random random = new Random(7);
    private final StringBuilder input = new StringBuilder();
    private final TreeMap<Integer, String> stored = new TreeMap<>();

    // faults
    boolean echoStuck;
    boolean blankMissing;
    boolean halfLines;
    /** The interval cannot be changed. */
    boolean intervalStuck;

    boolean textModeOnly;
    boolean eraseRefused;
    /** This number of message notices is not sent. */
    int noticesLost;

    boolean registered = true;
    /** What it has of keys: the modem refuses to report them. */
    public boolean deaf;
    /** As a stick of Huawei's: the sound of calls is on a second line. */
    public boolean hasSound;

    /** The least time between two equal keys: as it was left by an earlier user. */
    int equalKeyMillis = 1000;

    private boolean echo = true;
    private boolean reportsDuration;
    private boolean prompted;
    private long nowNanos;
    private long startedAtNanos;
    private long silentUntilNanos;
    private boolean silenceLoses;
    private char lastKey;
    private long lastKeyNanos = Long.MIN_VALUE / 2;
    private long nextRingNanos;
    private String caller = "";
    private boolean active;
    private String waiting = "";

    /** What the client has sent. */
    final List<String> commands = new ArrayList<>();

    final StringBuilder tonesSent = new StringBuilder();
    final List<String> messagesSent = new ArrayList<>();

    EmulatedModem(Family family, Consumer<byte[]> toHost) {
        this.family = family;
        this.toHost = toHost;
    }

    // ---- what happens to it ----------------------------------------------------------------------------------------

    void advance(long nanos) {
        nowNanos = nanos;
        if (!caller.isEmpty() && !active && nowNanos >= nextRingNanos) {
            ring();
        }
        while (!due.isEmpty() && due.peek().atNanos() <= nowNanos) {
            if (nowNanos < silentUntilNanos && !silenceLoses) {
                return;
            }
            byte[] octets = due.remove().octets();
            if (nowNanos >= silentUntilNanos) {
                toHost.accept(octets);
            }
        }
    }

    private void ring() {
        nextRingNanos = nowNanos + 5_000 * MILLI;
        say("RING");
        say("+CLIP: \"" + caller + "\",129,\"\",0,\"\",0");
    }

    void call(String from) {
        caller = from;
        nextRingNanos = nowNanos;
    }

    void callerHangsUp() {
        if (!caller.isEmpty()) {
            caller = "";
            active = false;
            say("NO CARRIER");
        }
    }

    void secondCall(String from) {
        waiting = from;
        say("+CCWA: \"" + from + "\",129,1");
    }

    boolean isInCall() {
        return active;
    }

    boolean hasWaitingCall() {
        return !waiting.isEmpty();
    }

    /** A key of the caller. */
    void key(char key) {
        boolean dropped = key == lastKey && nowNanos - lastKeyNanos < equalKeyMillis * MILLI;
        lastKey = key;
        lastKeyNanos = nowNanos;
        if (active && !dropped && !deaf) {
            String report = family.report(key) + (reportsDuration ? ",120" : "");
            say(blankMissing ? report.replace(": ", ":") : report);
        }
    }

    /** It starts again, as after a voltage drop, and takes no command for 2 s. */
    void reboot() {
        caller = "";
        active = false;
        echo = true;
        equalKeyMillis = 1000;
        prompted = false;
        input.setLength(0);
        due.clear();
        raw("\u0000\u00ffIIII\u0000");
        say("RDY");
        say("+CFUN: 1");
        say("+CPIN: READY");
        startedAtNanos = nowNanos + 2_000 * MILLI;
    }

    /** Says nothing for a time; then what it has to say comes late, or is lost. */
    void silence(long millis, boolean loses) {
        silentUntilNanos = nowNanos + millis * MILLI;
        silenceLoses = loses;
    }

    /** Octets that are no line of its own. */
    void raw(String octets) {
        due.add(new Due(nowNanos + ANSWER_NANOS, octets.getBytes(StandardCharsets.ISO_8859_1)));
    }

    void message(String from, String text) {
        DeliverTpdu deliver = new DeliverTpdu(
                false,
                false,
                false,
                new SmsAddress(from.startsWith("+") ? SmsAddress.INTERNATIONAL : 0, 1, from.replace("+", "")),
                0,
                new Timestamp(OctetString.ofHex(String.format("62112261%02d0000", 10 + stored.size()))),
                MessageSplitter.split(text, 1).get(0));
        String pdu = "0791947100000000" + TpduCodec.encode(deliver).toString().toUpperCase(Locale.ROOT);
        int index = stored.isEmpty() ? 1 : stored.lastKey() + 1;
        stored.put(
                index,
                textModeOnly
                        ? "\"REC UNREAD\",\"" + from + "\",\"\",\"26/11/22,06:00:00+00\"\n" + text
                        : "1,," + (pdu.length() / 2 - 8) + "\n" + pdu);
        if (noticesLost == 0) {
            say("+CMTI: \"SM\"," + index);
        }
        noticesLost = Math.max(0, noticesLost - 1);
    }

    int messagesStored() {
        return stored.size();
    }

    // ---- commands --------------------------------------------------------------------------------------------------

    void received(String octets) {
        for (char octet : octets.toCharArray()) {
            if (prompted) {
                prompted(octet);
            } else if (octet == '\r') {
                command(input.toString());
                input.setLength(0);
            } else if (octet != '\n' && octet != '\u001b') {
                input.append(octet);
            }
        }
    }

    private void prompted(char octet) {
        if (octet == '\u001a') {
            prompted = false;
            messagesSent.add(input.toString());
            input.setLength(0);
            say("+CMGS: " + messagesSent.size());
            say("OK");
        } else if (octet == '\u001b') {
            prompted = false;
            input.setLength(0);
            say("OK");
        } else {
            input.append(octet);
        }
    }

    private void command(String line) {
        commands.add(line);
        if (nowNanos < startedAtNanos || nowNanos < silentUntilNanos && silenceLoses) {
            return;
        }
        if (echo || echoStuck) {
            raw(line + "\r");
        }
        String upper = line.toUpperCase(Locale.ROOT);
        if (upper.startsWith("AT")) {
            answer(upper);
        }
    }

    private void answer(String line) {
        switch (line) {
            case "AT", "ATV1", "AT+CMEE=1", "AT+CLIP=1", "AT+VTD=2", "AT+CNMI=2,1,0,0,0", "AT+COPS=3,0", "AT+CREG=1" ->
                ok();
            case "ATE0" -> {
                echo = false;
                ok();
            }
            case "AT+CGMI" -> ok(family.manufacturer);
            case "AT+CGMM" -> ok("MODULE");
            case "AT+CPIN?" -> ok("+CPIN: READY");
            case "AT^CVOICE?" -> ok(hasSound ? "^CVOICE:0,8000,16,20" : "^CVOICE:1");
            case "AT^DDSETEX=2" -> ok(hasSound && active);
            case "AT+VTS=?" -> ok("+VTS: (0-9,*,#,A-D)");
            case "AT+CLCC" -> listCalls();
            case "ATA" -> takeCall();
            case "ATH" -> {
                caller = "";
                active = false;
                ok();
            }
            case "AT+CHLD=0" -> {
                waiting = "";
                ok();
            }
            case "AT+CMGF=0" -> ok(!textModeOnly);
            case "AT+CMGF=1" -> ok();
            case "AT+CPMS=\"SM\",\"SM\",\"SM\"" -> ok("+CPMS: 0,50,0,50,0,50");
            case "AT+COPS?" -> ok("+COPS: 0,0,\"TestNet\"");
            case "AT+CREG?" -> ok("+CREG: 1," + (registered ? 1 : 2));
            default -> answerWithValue(line);
        }
    }

    private void answerWithValue(String line) {
        if (line.startsWith(family.enabler) && !deaf) {
            enable(line);
        } else if (line.equals("AT+DDET?") && family.enabler.equals("AT+DDET=")) {
            ok("+DDET: 1," + equalKeyMillis + "," + (reportsDuration ? 1 : 0) + ",0");
        } else if (line.startsWith("AT+VTS=")) {
            tonesSent.append(line.substring(7));
            ok(active);
        } else if (line.startsWith("AT+CMGS=")) {
            prompted = true;
            raw("\r\n> ");
        } else if (line.startsWith("AT+CMGL=")) {
            listMessages(line.contains("ALL"));
        } else if (line.startsWith("AT+CMGR=")) {
            String content = stored.get(Integer.parseInt(line.substring(8)));
            if (content != null) {
                for (String part : ("+CMGR: " + content).split("\n")) {
                    say(part);
                }
            }
            ok();
        } else if (line.startsWith("AT+CMGD=")) {
            if (!eraseRefused) {
                stored.remove(Integer.parseInt(line.substring(8)));
            }
            ok(!eraseRefused);
        } else {
            say("ERROR");
        }
    }

    /** A SIM7600 knows no further values. */
    private void enable(String line) {
        boolean more = line.contains(",");
        if (family == Family.SIM7600 && more) {
            say("ERROR");
            return;
        }
        if (family == Family.SIM800 && more && !intervalStuck) {
            equalKeyMillis = Integer.parseInt(line.split(",")[1]);
            reportsDuration = line.endsWith(",0,1");
        } else if (family != Family.SIM800) {
            equalKeyMillis = 0;
        }
        ok();
    }

    private void listMessages(boolean textMode) {
        if (textMode == textModeOnly) {
            stored.forEach((index, content) -> {
                for (String part : ("+CMGL: " + index + "," + content).split("\n")) {
                    say(part);
                }
            });
        }
        ok(textMode == textModeOnly);
    }

    private void listCalls() {
        if (!caller.isEmpty()) {
            say("+CLCC: 1,1," + (active ? 0 : 4) + ",0,0,\"" + caller + "\",129,\"\"");
        }
        if (!waiting.isEmpty()) {
            say("+CLCC: 2,1,5,0,0,\"" + waiting + "\",129,\"\"");
        }
        ok();
    }

    private void takeCall() {
        active = !caller.isEmpty();
        if (active) {
            ok();
        } else {
            say("NO CARRIER");
        }
    }

    private void ok(String... lines) {
        for (String line : lines) {
            say(line);
        }
        say("OK");
    }

    private void ok(boolean good) {
        say(good ? "OK" : "ERROR");
    }

    private void say(String line) {
        String whole = "\r\n" + line + "\r\n";
        if (!halfLines) {
            raw(whole);
            return;
        }
        for (int from = 0; from < whole.length(); ) {
            int to = Math.min(whole.length(), from + 1 + random.nextInt(4));
            long at =
                    due.isEmpty() ? nowNanos : Math.max(nowNanos, due.getLast().atNanos());
            due.add(new Due(at + 2 * MILLI, whole.substring(from, to).getBytes(StandardCharsets.ISO_8859_1)));
            from = to;
        }
    }
}
