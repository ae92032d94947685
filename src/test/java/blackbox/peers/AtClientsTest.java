package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Dist;
import blackbox.RunningProgram;
import blackbox.Scenario;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** {@code docs/AT.md}, block by block: programs that were written for GSM modems use the phone and drive the robot. */
@Tag("peer")
class AtClientsTest {
    private static final String SECOND = "5550101";
    /** Clients that poll must see the robot ring, on a busy machine too. */
    private static final String RINGING_MILLIS = "4000";

    private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private Scenario scenario;
    private RunningProgram robot;
    private String phonePort;
    private String secondPort;

    /** The blocks of a section of the page, each a script; those of programs of ours left out. */
    private static List<String> blocks(String section) throws IOException {
        String page = Files.readString(Dist.root().resolve("docs/AT.md"));
        String text = page.substring(page.indexOf("## " + section + "\n")).replaceFirst("(?s)(## .*?)\n## .*", "$1");
        List<String> blocks = new ArrayList<>();
        for (String part : text.split("\n\n")) {
            if (part.startsWith("    ")) {
                blocks.add(part.stripIndent().strip());
            }
        }
        return blocks;
    }

    private void begin(String title) throws Exception {
        begin(title, "plain");
    }

    /** The centre, a robot and two phones; the terminal devices of the page. @param profile the phones' */
    private void begin(String title, String profile) throws Exception {
        Peer.SOCAT.require();
        scenario = new Scenario(title);
        scenario.center();
        robot = scenario.robot("empty.map", "--speed", "20", "--at", "0", "--answer-after", RINGING_MILLIS);
        phonePort = portOf(Scenario.PHONE, profile);
        secondPort = portOf(SECOND, profile);
        for (String block : blocks("A terminal device")) {
            run(block);
        }
    }

    private String portOf(String number, String profile) throws Exception {
        return scenario.phone(number, "--at", "0", "--at-profile", profile)
                .said("ready")
                .field("at");
    }

    private String run(String block) throws Exception {
        String script = block.replace("127.0.0.1:7000", "127.0.0.1:" + phonePort)
                .replace("127.0.0.1:7001", "127.0.0.1:" + secondPort)
                .replace(".sh 7000", ".sh " + phonePort)
                .replace("src/test/peers", Dist.root().resolve("src/test/peers").toString());
        ProcessBuilder builder =
                Peer.BASH.process("-c", script).directory(scenario.folder().toFile());
        if (block.endsWith("&")) {
            File nowhere = new File("/dev/null");
            scenario.beside(new ProcessBuilder("bash", "-c", script.substring(0, script.length() - 1))
                    .directory(scenario.folder().toFile())
                    .redirectErrorStream(true)
                    .redirectOutput(nowhere)
                    .start());
            Path device = scenario.folder().resolve(block.replaceAll("(?s).*link=(\\w+).*", "$1"));
            awaitDevice(device, FileTime.fromMillis(0));
            return "";
        }
        Path device = scenario.folder().resolve("ttyM1");
        FileTime before = made(device);
        Peer.Output output = Peer.run(builder);
        scenario.tell("$ " + block + "\n" + output.text().indent(4));
        if (block.startsWith("gammu ") || block.contains(".sh ttyM1")) {
            awaitDevice(device, before);
        }
        return output.expectSuccess();
    }

    /** When the device was made; the epoch while there is none, which socat's end brings about at any moment. */
    private static FileTime made(Path device) throws IOException {
        try {
            return Files.getLastModifiedTime(device, LinkOption.NOFOLLOW_LINKS);
        } catch (NoSuchFileException none) {
            return FileTime.fromMillis(0);
        }
    }

    /** Waits until the loop of the page has made the device anew. */
    private static void awaitDevice(Path device, FileTime before) throws IOException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(RunningProgram.PATIENCE_SECONDS);
        while (made(device).compareTo(before) <= 0) {
            assertTrue(System.nanoTime() < end, device + " is not made");
            LockSupport.parkNanos(POLL_NANOS);
        }
    }

    @Test
    void threeCommandsByHandAreAnswered() throws Exception {
        try {
            begin("AT commands by hand");
            String answers = run(blocks("A first look").get(0));
            assertTrue(answers.contains("M1"), answers);
            assertTrue(answers.contains("+COPS: 0,0,\"SimGSM\""), answers);
            assertTrue(answers.contains("+CSQ: 25,99"), answers);
        } finally {
            scenario.close();
        }
    }

    @Test
    void gammuSendsAnOrderReadsTheReplyCallsAndKeys() throws Exception {
        Peer.GAMMU.require();
        try {
            begin("gammu");
            List<String> blocks = blocks("gammu");
            assertEquals(13, blocks.size());
            run(blocks.get(0));
            String identity = run(blocks.get(1));
            assertTrue(identity.contains("SimGSM"), identity);
            assertTrue(identity.contains("001010005550100"), identity);
            String network = run(blocks.get(2));
            assertTrue(network.contains("home network"), network);
            assertTrue(run(blocks.get(3)).contains("OK"));
            robot.expect("outcome", "tone", "3");
            robot.expect("reply");
            String messages = run(blocks.get(4));
            assertTrue(messages.contains("3 Done: #**20. Stopped at 0.200"), messages);
            run(blocks.get(5));
            assertTrue(run(blocks.get(4)).contains("0 SMS parts"));
            assertTrue(run(blocks.get(6)).contains("\"5550100\""));
            run(blocks.get(7));
            robot.expect("call", "from", Scenario.PHONE);
            robot.expect("tone", "key", "1");
            run(blocks.get(8));
            robot.expect("outcome", "tone", "3");
            run(blocks.get(9));
            robot.expect("released", "cause", "16");
            assertTrue(run(blocks.get(10)).contains("all types of diverts"));
            String divert = run(blocks.get(11));
            assertTrue(divert.contains("Number               : +5550299"), divert);
            run(blocks.get(12));
            assertFalse(run(blocks.get(11)).contains("+5550299"));
        } finally {
            scenario.close();
        }
    }

    @Test
    void gammuEntersThePin() throws Exception {
        Peer.GAMMU.require();
        Peer.SOCAT.require();
        scenario = new Scenario("gammu and a card that asks for its PIN");
        try {
            Path card = Files.writeString(
                    scenario.folder().resolve("ana.sim"),
                    "sim number=5550100 imsi=001010005550100 k=465b5ce8b199b49faa5f0a2ee238a6bc algorithm=comp128v1"
                            + " pin=1234 puk=12345678\n");
            scenario.center("--hlr", card.toString());
            RunningProgram phone = scenario.unregisteredPhone(Scenario.PHONE, "--sim", card.toString(), "--at", "0");
            phonePort = phone.said("ready").field("at");
            run(blocks("A terminal device").get(0));
            run(blocks("gammu").get(0));
            String locked = run("gammu -c gammurc getsecuritystatus");
            assertTrue(locked.contains("Waiting for PIN"), locked);
            run("gammu -c gammurc entersecuritycode PIN 1234");
            phone.expect("registered", "number", Scenario.PHONE);
            String open = run("gammu -c gammurc getsecuritystatus");
            assertTrue(open.contains("Nothing to enter"), open);
        } finally {
            scenario.close();
        }
    }

    @Test
    void smstoolsSendsAnOrderAndReceivesTheReply() throws Exception {
        Peer.SMSD.require();
        try {
            begin("smstools");
            String printed = run(blocks("smstools").get(0));
            assertTrue(printed.contains("sent: order"), printed);
            assertTrue(printed.contains("received: From: 5550200"), printed);
            assertTrue(printed.contains("received: 3 Done: #*#90."), printed);
        } finally {
            scenario.close();
        }
    }

    @Test
    void pythonGsmmodemCallsInBothDirections() throws Exception {
        Peer.require(Peer.PYTHON.run("-c", "import gsmmodem").status() == 0, "python-gsmmodem-new");
        try {
            begin("python-gsmmodem-new", "sim800");
            List<String> blocks = blocks("python-gsmmodem-new");
            run(blocks.get(0));
            String printed = run(blocks.get(1));
            assertTrue(printed.contains("network SimGSM signal 25 own number 5550100"), printed);
            assertTrue(printed.contains("delivered True"), printed);
            assertTrue(printed.contains("reply 5550200 3 Done: #**20."), printed);
            assertTrue(printed.contains("ussd 5550100"), printed);
            assertTrue(printed.contains("call to the robot: its reply 3 heard"), printed);
            assertTrue(printed.contains("call from +5550101 answered, keys heard in both directions"), printed);
        } finally {
            scenario.close();
        }
    }

    @Test
    void modemManagerRegistersSendsAnOrderAndCalls() throws Exception {
        Peer.MODEM_MANAGER.require();
        Peer.MMCLI.require();
        Peer.require(System.getProperty("user.name").equals("root"), "polkitd, which only root can start");
        try {
            begin("ModemManager");
            String printed = run(blocks("ModemManager").get(0));
            for (String line : List.of(
                    "modem.generic.state +: registered",
                    "modem.3gpp.operator-name +: SimGSM",
                    "modem.generic.own-numbers.value\\[1] +: 5550100",
                    "modem.generic.signal-quality.value +: (8[0-9]|9[0-9]|100)",
                    "sms.content.number +: 5550200",
                    "sms.content.text +: 3 Done: #\\*\\*20\\..*",
                    "successfully send dtmf",
                    "successfully hung up the call")) {
                assertTrue(printed.lines().anyMatch(each -> each.matches(line)), line + " is not in\n" + printed);
            }
        } finally {
            scenario.close();
        }
    }

    @Test
    void ofonoSendsAnOrderAndAsksItsNumber() throws Exception {
        Peer.OFONO.require();
        try {
            begin("oFono");
            String printed = run(blocks("oFono").get(0));
            assertEquals("""
                    "SimGSM"
                    /phonesim/message
                    "3 REPLY"
                    "5550100"
                    """, printed.replaceAll("\"3 .*\"", "\"3 REPLY\""));
        } finally {
            scenario.close();
        }
    }

    @Test
    void wvdialGetsNoCarrier() throws Exception {
        Peer.WVDIAL.require();
        try {
            begin("wvdial");
            String printed = run(blocks("wvdial").get(0));
            assertTrue(printed.contains("--> No Carrier!"), printed);
        } finally {
            scenario.close();
        }
    }
}
