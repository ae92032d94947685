package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.ConsoleEvent;
import blackbox.RunningProgram;
import blackbox.Scenario;
import blackbox.SpeechGap;
import blackbox.WebPhone;
import java.io.IOException;
import java.net.DatagramSocket;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * A phone and a robot on a real Osmocom core, over two towers of the village. {@link OsmocomTest} starts it beside that core.
 * It prints what it does, and its exit status is 0 only if everything went as it should.
 */
final class OsmocomSession extends Scenario {

    private static final int AIR_PORT = 4729;

    private final Path capture;
    /** The ciphering algorithm of core and cells, if there is authentication. */
    private String algorithm = "a5/1";

    private RunningProgram cells;
    /** Options of terminals with keys; none without authentication. */
    private List<String> sims = List.of();

    /** Where terminals connect. */
    private String cellsAddress;

    private OsmocomSession(Path capture) {
        super("a phone and a robot on osmo-bsc, osmo-msc, osmo-hlr and osmo-mgw");
        this.capture = capture;
    }

    /** @param args what to play, session, a5/1, a5/3, crowd, calls, halves or browser, and the capture to write */
    public static void main(String[] args) throws Exception {
        try (OsmocomSession session = new OsmocomSession(Path.of(args[1]))) {
            switch (args[0]) {
                case "crowd" -> session.crowd();
                case "calls" -> session.calls();
                case "halves" -> session.halves();
                case "browser" -> session.browser();
                case "cards" -> session.cardsRegister();
                case "a5/1", "a5/3" -> session.ciphered(args[0]);
                default -> session.play();
            }
        }
    }

    /** As {@link #play}, but the core authenticates the SIMs and ciphers; what the air shows is captured, too. */
    private void ciphered(String a5) throws IOException, InterruptedException {
        algorithm = a5;
        sims = List.of("--sim", capture.resolveSibling("sims.txt").toString());
        play();
        String deciphered = Peer.PYTHON
                .run(Peer.source("osmocom/decipher.py"), capture.toString(), String.valueOf(AIR_PORT), "3003")
                .expectSuccess()
                .strip();
        String last = deciphered.substring(deciphered.lastIndexOf('\n') + 1);
        assertTrue(last.matches("readable ([1-9][0-9]+) of \\1 without-key 0"), last);
        assertTrue(deciphered.contains(" " + a5 + " "), deciphered);
        tell("libosmogsm and libosmocoding: of the ciphered blocks of SDCCH and SACCH are " + last);
        cannotCipherWithAnotherKey();
    }

    /** COMP128 version 3 in place of 2: SRES is the same, Kc is not. */
    private void cannotCipherWithAnotherKey() throws IOException, InterruptedException {
        String cards = Files.readString(capture.resolveSibling("sims.txt")).replace("comp128v2", "comp128v3");
        openCells("cells again", world("village.town"));
        RunningProgram phone = locked("5550101", Files.writeString(capture.resolveSibling("other-key.sim"), cards));
        cells.expect("cipher-mismatch", "number", "5550101", "algorithm", algorithm);
        cells.expect("radio-link-failure", "number", "5550101");
        assertTrue(!phone.expect("unregistered").fields().containsKey("cause"), "no reject reaches the phone");
        phone.quit();
        cells.quit();
        tell("a card with another Kc is not registered");
    }

    /** Wireshark names all that is in the clear, and finds nothing that is sent after ciphering. */
    private void airIsSound() throws IOException {
        boolean isCiphered = !sims.isEmpty();
        String decoding = "udp.port==" + AIR_PORT + ",gsmtap";
        List<String> clear = Wireshark.decoded(capture, decoding, "gsmtap.type==1");
        int bursts = Wireshark.decoded(capture, decoding, "gsmtap.type==3").size();
        int accesses =
                Wireshark.decoded(capture, decoding, "gsmtap.chan_type==3").size();
        requireOnAir(
                clear,
                true,
                List.of(
                        "System Information Type 1",
                        "System Information Type 2",
                        "System Information Type 3",
                        "System Information Type 4",
                        "Paging Request Type 1",
                        "Immediate Assignment",
                        "SABM(DTAP) (MM) Location Updating Request",
                        "SABM(DTAP) (MM) CM Service Request",
                        "SABM(DTAP) (RR) Paging Response"));
        requireOnAir(
                clear,
                isCiphered,
                List.of("Authentication Request", "Authentication Response", "Ciphering Mode Command"));
        requireOnAir(
                clear,
                !isCiphered,
                List.of(
                        "Accept",
                        "Complete",
                        "CP-DATA",
                        "Setup",
                        "Handover Command",
                        "Assignment Command",
                        "Alerting"));
        if (!isCiphered) {
            requireOnAir(
                    clear,
                    true,
                    List.of("System Information Type 5", "System Information Type 6", "Measurement Report"));
        }
        assertTrue(accesses > 0, "no access bursts");
        assertEquals(isCiphered, bursts > 0, bursts + " ciphered bursts");
        assertEquals(
                List.of(),
                Wireshark.decoded(capture, decoding, "gsmtap && (_ws.malformed || _ws.expert.severity >= 0x800000)"));
        tell("on the air: " + clear.size() + " blocks in the clear, none malformed, " + accesses
                + " of them access bursts; " + bursts + " ciphered bursts");
    }

    private static void requireOnAir(List<String> clear, boolean isExpected, List<String> names) {
        for (String name : names) {
            assertEquals(isExpected, clear.stream().anyMatch(line -> line.contains(name)), name + " on the air");
        }
    }

    private void play() throws IOException, InterruptedException {
        Process tshark = capture();
        // a receiver: without one the system answers each packet of the air by ICMP
        try (DatagramSocket air = new DatagramSocket(AIR_PORT)) {
            assertTrue(air.isBound());
            openCells(world("village.town"));
            RunningProgram phone = terminal("phone", "simgsm-phone", PHONE);
            RunningProgram robot = terminal(
                    "robot", "simrobot", ROBOT, "--world", world("empty.map").toString(), "--answer-after", "1500");
            order(phone, robot);
            handover(phone, robot);
            phone.say("hangup");
            phone.expect("released", "cause", "16");
            robot.expect("released", "cause", "16");
            assertEquals(0, phone.quit());
            assertEquals(0, robot.quit());
            assertEquals(0, cells.quit());
        } finally {
            tshark.destroy();
            tshark.waitFor(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
        String port = cellsAddress.substring(cellsAddress.indexOf(':') + 1);
        soundAs("osmo-bsc's side", "tcp.port==3003,gsm_ipa");
        soundAs("the terminals' side", "tcp.port==" + port + ",gsm_ipa");
        airIsSound();
    }

    /** Starts tshark, which creates its file once it has opened the interface. */
    private Process capture() throws IOException, InterruptedException {
        try (WatchService folder = FileSystems.getDefault().newWatchService()) {
            capture.getParent().register(folder, StandardWatchEventKinds.ENTRY_CREATE);
            Process tshark = Peer.TSHARK
                    .process("-q", "-i", "lo", "-s", "0", "-w", capture.toString())
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            while (Files.notExists(capture)) {
                WatchKey created = folder.poll(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
                assertNotNull(created, "tshark does not capture");
                created.reset();
            }
            return tshark;
        }
    }

    private void openCells(Path town) {
        openCells("cells", town);
    }

    private void openCells(String name, Path town) {
        cells = start(
                name,
                "simgsm-cells",
                "--headless",
                "--town",
                town.toString(),
                "--controller",
                "osmo-bsc",
                "--center",
                "127.0.0.1:3003",
                "--port",
                "0",
                "--a5",
                "0,1," + algorithm.substring(3),
                "--gsmtap",
                "127.0.0.1:" + AIR_PORT);
        cellsAddress = "127.0.0.1:" + cells.expect("ready").field("port");
    }

    private RunningProgram terminal(String name, String program, String number, String... more) {
        List<String> arguments = new ArrayList<>(
                List.of("--headless", "--lang", "en", "--no-sound", "--center", cellsAddress, "--number", number));
        arguments.addAll(List.of(more));
        arguments.addAll(sims);
        RunningProgram terminal = start(name, program, arguments.toArray(String[]::new));
        terminal.expect("registered", "number", number);
        requireCiphered(number);
        tell(name + " " + number + " is registered");
        return terminal;
    }

    private void requireCiphered(String number) {
        if (!sims.isEmpty()) {
            cells.expect("cipher", "number", number, "algorithm", algorithm);
            tell(number + " is ciphered");
        }
    }

    /** An order by short message, with delivery report and reply; then one by tones. */
    private void order(RunningProgram phone, RunningProgram robot) {
        phone.say("sms " + ROBOT + " ** #**20 **");
        phone.expect("sms-sent", "to", ROBOT);
        robot.expect("sms", "from", PHONE);
        robot.expect("pose", "x", "0.2000", "y", "0.0000");
        phone.expect("sms", "from", ROBOT);
        phone.said("sms-delivered");
        tell("an order by short message was done, reported and answered");

        awaitIdle();
        call(phone);
        phone.say("press **#**20**");
        phone.expect("tone", "key", "6");
        phone.expect("tone", "key", "3");
        robot.expect("pose", "x", "0.4000", "y", "0.0000");
        tell("an order by tones was done");
    }

    /**
     * Waits until the phone has left its channel. osmo-msc 1.9 refuses a service for 5 s that was asked for on a connection
     * which it had begun to release.
     */
    private void awaitIdle() {
        String state;
        do {
            state = place(cells, PHONE).field("state");
        } while (!state.equals("idle"));
    }

    /** The phone is carried to the other tower while the robot executes an order, and gives another one from there. */
    private void handover(RunningProgram phone, RunningProgram robot) {
        phone.say("press **#**400**");
        phone.expect("tone", "key", "6");
        cells.say("place " + PHONE + " 3700 0");
        cells.expect("handover", "number", PHONE, "from", "west", "to", "east", "result", "success");
        int gapMillis = SpeechGap.of(cells);
        phone.expect("tone", "key", "3");
        robot.expect("pose", "x", "4.4000", "y", "0.0000");
        phone.say("press **#*#90**");
        phone.expect("tone", "key", "3");
        robot.expect("pose", "heading", "270.00");
        tell("handed over in the middle of an order; speech gap " + gapMillis + " ms; the next order was done");
        SpeechGap.requireShort(gapMillis, cells);
    }

    /** Two cells programs, each with one of the village's towers: the phone is on the one, the robot on the other. */
    private void halves() throws IOException, InterruptedException {
        openCells("west cells", half("west"));
        RunningProgram west = cells;
        RunningProgram phone = terminal("phone", "simgsm-phone", PHONE);
        openCells("east cells", half("east"));
        RunningProgram robot = terminal(
                "robot", "simrobot", ROBOT, "--world", world("empty.map").toString(), "--answer-after", "1500");
        assertEquals("east", place(cells, ROBOT).field("cell"));
        RunningProgram east = cells;
        cells = west;
        assertEquals("west", place(west, PHONE).field("cell"));
        order(phone, robot);
        phone.say("hangup");
        phone.expect("released", "cause", "16");
        robot.expect("released", "cause", "16");
        tell(
                "two cells programs on one core: an order by short message and a call with an order went from one to the other");
        assertEquals(0, phone.quit());
        assertEquals(0, robot.quit());
        assertEquals(0, west.quit());
        assertEquals(0, east.quit());
    }

    /** A page of the gateway orders by short message and by tones, and the robot answers it both ways. */
    private void browser() throws InterruptedException {
        openCells(world("village.town"));
        RunningProgram robot = terminal(
                "robot", "simrobot", ROBOT, "--world", world("empty.map").toString(), "--answer-after", "1500");
        RunningProgram gateway = start(
                "gateway",
                "simgsm-gateway",
                "--headless",
                "--center",
                cellsAddress,
                "--numbers",
                PHONE + "-" + PHONE,
                "--key",
                "word");
        try (WebPhone phone = new WebPhone(gateway.expect("ready").field("web"), "{\"key\":\"word\"}")) {
            phone.expect("registered");
            phone.say("{\"do\":\"sms\",\"number\":\"" + ROBOT + "\",\"text\":\"** #**20 **\"}");
            phone.expect("sms-sent");
            robot.expect("sms", "from", PHONE);
            phone.expect("sms", "from", ROBOT);
            awaitIdle();
            phone.say("{\"do\":\"dial\",\"number\":\"" + ROBOT + "\"}");
            phone.expect("connected");
            phone.speak();
            phone.expect("tone", "key", "1");
            phone.press("**#**20**");
            phone.expect("tone", "key", "3");
            robot.expect("pose", "x", "0.4000", "y", "0.0000");
            phone.say("{\"do\":\"hangup\"}");
            phone.expect("released", "cause", "16");
            robot.expect("released", "cause", "16");
        }
        tell("a browser's orders by short message and by tones were done and answered");
        assertEquals(0, gateway.quit());
        assertEquals(0, robot.quit());
        assertEquals(0, cells.quit());
    }

    /** A card of each algorithm from 5550100 on, one with a PIN, and the robot's. */
    static String cards() {
        String keys = " k=465b5ce8b199b49faa5f0a2ee238a6bc ";
        String opc = "opc=cd63cb71954a9f4e48a5994e37a02baf";
        StringBuilder file = new StringBuilder();
        String[] words = {
            "algorithm=comp128v1",
            "algorithm=comp128v2",
            "algorithm=comp128v3",
            opc,
            "algorithm=comp128v3",
            "algorithm=comp128v2 pin=1234 puk=12345678"
        };
        for (int i = 0; i < words.length; i++) {
            file.append("sim number=555010" + i + " imsi=00101000555010" + i + keys + words[i] + "\n");
        }
        return file + "sim number=" + ROBOT + " imsi=001010005550200" + keys + opc + "\n";
    }

    /** The cards register; one with a wrong key does not; one without its PIN makes an emergency call. */
    private void cardsRegister() throws IOException, InterruptedException {
        Path file = capture.resolveSibling("cards.sim");
        Process tshark = capture();
        try {
            openCells(world("village.town"));
            for (int i = 0; i < 4; i++) {
                RunningProgram phone = terminal("phone " + i, "simgsm-phone", "555010" + i, "--sim", file.toString());
                phone.expect("network-time");
                phone.quit();
            }
            tell("comp128v1, comp128v2, comp128v3 and milenage are authenticated, and told the time");
            Path wrong =
                    Files.writeString(capture.resolveSibling("wrong.sim"), cards().replace("k=465b5ce8", "k=00000000"));
            RunningProgram liar = locked("5550104", wrong);
            liar.expect("unregistered", "cause", "3");
            RunningProgram robot = terminal(
                    "robot",
                    "simrobot",
                    ROBOT,
                    "--sim",
                    file.toString(),
                    "--world",
                    world("empty.map").toString());
            RunningProgram phone = locked("5550105", file);
            phone.expect("sim", "state", "pin", "tries", "3");
            phone.say("dial 112");
            tell("an emergency call without a PIN: " + phone.expect("released").fields());
            phone.say("pin 1234");
            phone.expect("registered");
            phone.say("dial 112");
            robot.expect("call");
            phone.expect("connected");
            phone.expect("tone", "key", "1");
            phone.say("hangup");
            robot.expect("released", "cause", "16");
            tell("an emergency call was answered by the robot");
        } finally {
            tshark.destroy();
            tshark.waitFor(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
        soundAs("osmo-bsc's side", "tcp.port==3003,gsm_ipa");
    }

    private RunningProgram locked(String number, Path cards) {
        return start(
                "phone-" + number,
                "simgsm-phone",
                "--headless",
                "--lang",
                "en",
                "--no-sound",
                "--center",
                cellsAddress,
                "--number",
                number,
                "--sim",
                cards.toString());
    }

    /** The village's town file with one of its towers only. */
    private Path half(String tower) throws IOException {
        List<String> lines = Files.readAllLines(world("village.town"));
        lines.removeIf(line -> line.startsWith("tower ") && !line.startsWith("tower " + tower + " "));
        return Files.write(capture.resolveSibling(tower + ".town"), lines);
    }

    /** What a cells program says of a mobile. */
    private static ConsoleEvent place(RunningProgram cells, String number) {
        cells.say("mobiles");
        ConsoleEvent mobile = cells.expect("mobile", "number", number);
        cells.expect("end");
        return mobile;
    }

    /** A hundred phones register and send each other a hundred messages. */
    private void crowd() throws InterruptedException {
        openCells(Path.of(Peer.source("osmocom/crowd.town")));
        RunningProgram load = start(
                "load",
                "simgsm-modem",
                "load",
                "--center",
                cellsAddress,
                "--phones",
                "100",
                "--sms",
                "100",
                "--seconds",
                "1");
        ConsoleEvent result = load.expect("load", "phones", "100", "sms", "100", "smslost", "0");
        assertEquals(0, load.awaitExit());
        tell("100 phones: " + result.field("attachrate") + " registrations and " + result.field("smsrate")
                + " messages a second");
        assertEquals(0, cells.quit());
    }

    /** 40 phones hold 20 calls. A called one rings before it answers, as a user's does: osmo-msc needs that. */
    private void calls() throws InterruptedException {
        openCells(capture.resolveSibling("calls.town"));
        RunningProgram load = start(
                "load",
                "simgsm-modem",
                "load",
                "--center",
                cellsAddress,
                "--phones",
                "40",
                "--calls",
                "20",
                "--answer-after",
                "1500",
                "--seconds",
                "5");
        ConsoleEvent result = load.expect("load", "phones", "40", "calls", "20", "callslost", "0");
        assertEquals(0, load.awaitExit());
        int frames = Integer.parseInt(result.field("frames"));
        int lost = Integer.parseInt(result.field("lost"));
        // How many frames come in time depends on the machine's other work, so the count is only printed.
        assertTrue(lost < frames, lost + " of " + frames + " frames lost");
        tell("20 calls were held, " + lost + " of " + frames + " speech frames lost, " + result.field("p50ms")
                + " ms from mouth to ear");
        assertEquals(0, cells.quit());
    }

    /** Requires that tshark finds nothing malformed where it reads a port so. */
    private void soundAs(String side, String decoding) throws IOException {
        List<String> faults = Wireshark.decoded(capture, decoding, "_ws.malformed || _ws.expert.severity >= 0x800000");
        List<String> rsl = Wireshark.decoded(capture, decoding, "gsm_abis_rsl");
        assertTrue(rsl.size() > 100, side + ": " + rsl.size() + " RSL frames");
        assertEquals(List.of(), faults, side);
        tell(side + ": " + rsl.size() + " RSL frames, none malformed");
    }
}
