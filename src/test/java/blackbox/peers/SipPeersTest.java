package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.ConsoleEvent;
import blackbox.Dist;
import blackbox.RunningProgram;
import blackbox.Scenario;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** SIP phones that were written elsewhere call the robot and are called: baresip, linphonec, pjsua, SIPp. */
@Tag("peer")
class SipPeersTest {
    private static final String NUMBER = "5550100";
    private static final String KEYS = "**#**20**";
    private static final String KEY_SENT = "Finished sending RFC2833 dtmf";
    private static final int CALLS = Integer.getInteger("sip.calls", 200);
    private static final double LOSS = 0.05;

    @TempDir
    Path folder;

    private final Scenario scenario = new Scenario("SIP phones");
    private final List<Process> phones = new ArrayList<>();
    private int port;
    /** baresip's output, with all SIP messages. */
    private PrintedLines printed;

    @BeforeEach
    void start() {
        scenario.center();
    }

    @AfterEach
    void stop() throws Exception {
        phones.forEach(Process::destroyForcibly);
        for (Process phone : phones) {
            phone.waitFor();
        }
        scenario.close();
    }

    private RunningProgram gateway() throws IOException {
        RunningProgram gateway = scenario.sipGateway(List.of(NUMBER));
        port = Integer.parseInt(gateway.expect("ready").field("sip"));
        return gateway;
    }

    private static int freePorts() {
        return 20_000 + 2 * new Random().nextInt(6_000);
    }

    // baresip

    /** Starts baresip, which sends this file as its sound. @return its control socket */
    private Socket baresip(String sound) throws Exception {
        int own = freePorts();
        Files.writeString(folder.resolve("config"), """
                sip_listen 127.0.0.1:%d
                audio_source aufile,%s
                audio_player aufile,%s
                audio_alert none
                ausrc_srate 8000
                auplay_srate 8000
                ausrc_channels 1
                auplay_channels 1
                rtp_ports %d-%d
                jitter_buffer_type off
                module_path /usr/lib/baresip/modules
                module g711.so
                module aufile.so
                module_tmp uuid.so
                module_tmp account.so
                module_app menu.so
                module_app contact.so
                module_app ctrl_tcp.so
                ctrl_tcp_listen 127.0.0.1:%d
                """.formatted(
                        own, folder.resolve(sound), folder.resolve("played.wav"), own + 10, own + 30, own + 2));
        Files.writeString(
                folder.resolve("accounts"),
                "<sip:" + NUMBER + "@127.0.0.1:" + port + ">;auth_user=" + NUMBER
                        + ";auth_pass=secret;audio_codecs=PCMA;regint=60;answermode=auto\n");
        Files.writeString(
                folder.resolve("contacts"), "\"robot\" <sip:" + Scenario.ROBOT + "@127.0.0.1:" + port + ">\n");
        Process baresip = Peer.BARESIP
                .process("-s", "-f", folder.toString(), "-4")
                .redirectInput(Path.of("/dev/null").toFile())
                .start();
        phones.add(baresip);
        printed = new PrintedLines(baresip);
        printed.await("baresip is ready");
        return new Socket(InetAddress.getLoopbackAddress(), own + 2);
    }

    private static void say(Socket control, String command, String parameters) throws IOException {
        String json = "{\"command\":\"" + command + "\",\"params\":\"" + parameters + "\",\"token\":\"x\"}";
        control.getOutputStream().write((json.length() + ":" + json + ",").getBytes(StandardCharsets.US_ASCII));
    }

    private void sound(String name, String... effects) throws Exception {
        List<String> arguments = new ArrayList<>(List.of(
                "-n", "-r", "8000", "-c", "1", "-b", "16", folder.resolve(name).toString()));
        arguments.addAll(List.of(effects));
        Peer.SOX.run(arguments.toArray(String[]::new)).expectSuccess();
    }

    private String robotUri() {
        return "sip:" + Scenario.ROBOT + "@127.0.0.1:" + port;
    }

    @Test
    void baresipRegistersCallsKeysByEventsSendsAMessageAndIsCalled() throws Exception {
        Peer.BARESIP.require();
        RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
        RunningProgram gateway = gateway();
        sound("silence.wav", "trim", "0", "60");
        try (Socket control = baresip("silence.wav")) {
            gateway.expect("joined", "kind", "sip", "number", NUMBER);
            say(control, "dial", robotUri());
            robot.expect("tone", "key", "1");
            for (char key : KEYS.toCharArray()) {
                say(control, "sndcode", String.valueOf(key));
                robot.expectNext("keys", "keys", String.valueOf(key));
            }
            robot.expect("order", "text", KEYS, "verdict", "accepted");
            robot.expect("outcome", "tone", "3");
            assertEquals(
                    "call", gateway.say("users").expect("user", "kind", "sip").field("state"));
            say(control, "hangup", "");
            robot.expect("released", "cause", "16");

            say(control, "message", "** #*0 **");
            robot.expect("reply", "to", NUMBER);
            printed.await("3 Done: #*0.");

            RunningProgram phone = scenario.phone("5550101");
            phone.say("dial " + NUMBER);
            phone.expect("connected", "number", NUMBER);
            phone.say("sms " + NUMBER + " hello").expect("sms-delivered");
            phone.say("hangup");
            phone.expect("released", "cause", "16");
            say(control, "quit", "");
            gateway.expect("left", "number", NUMBER);
        }
    }

    @Test
    void tonesInTheSoundOfBaresipDriveTheRobot() throws Exception {
        Peer.BARESIP.require();
        Peer.SOX.require();
        RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
        RunningProgram gateway = gateway();
        Path tones = folder.resolve("tones.wav");
        Peer.run(new ProcessBuilder(Dist.command("simgsm-modem", List.of("tones", KEYS, tones.toString()))))
                .expectSuccess();
        Path order = folder.resolve("order.wav");
        Peer.SOX.run(tones.toString(), order.toString(), "pad", "2", "60").expectSuccess();
        try (Socket control = baresip("order.wav")) {
            gateway.expect("joined", "kind", "sip", "number", NUMBER);
            say(control, "dial", robotUri());
            robot.expect("order", "text", KEYS, "verdict", "accepted");
        }
    }

    // linphonec

    @Test
    void linphonecRegistersCallsKeysByEventsAndReceivesAMessage() throws Exception {
        Peer.LINPHONEC.require();
        RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
        RunningProgram gateway = gateway();
        Files.createDirectories(folder.resolve(".local/share/linphone"));
        int own = freePorts();
        Path settings = Files.writeString(folder.resolve("rc"), """
                [sip]
                sip_port=%d
                sip_tcp_port=-2
                default_proxy=0

                [proxy_0]
                reg_proxy=<sip:127.0.0.1:%d>
                reg_identity=sip:%s@127.0.0.1
                reg_sendregister=1
                reg_expires=120

                [auth_info_0]
                username=%s
                passwd=secret
                realm=simgsm

                [rtp]
                audio_rtp_port=%d
                """.formatted(own, port, NUMBER, NUMBER, own + 2));
        ProcessBuilder builder = Peer.LINPHONEC.process("-c", settings.toString(), "-d", "3");
        builder.environment().put("HOME", folder.toString());
        Process linphone = builder.redirectErrorStream(true).start();
        phones.add(linphone);
        printed = new PrintedLines(linphone);
        gateway.expect("joined", "kind", "sip", "number", NUMBER);
        type(linphone, "soundcard use files");
        type(linphone, "call " + robotUri());
        robot.expect("tone", "key", "1");
        for (int i = 1; i <= KEYS.length(); i++) {
            String key = KEYS.substring(i - 1, i);
            type(linphone, key);
            robot.expectNext("keys", "keys", key);
            // linphonec drops a key that is typed while it sends another
            int sent = i;
            printed.await(
                    all -> all.stream().filter(line -> line.contains(KEY_SENT)).count() == sent, KEY_SENT);
        }
        robot.expect("outcome", "tone", "3");
        type(linphone, "terminate");
        robot.expect("released", "cause", "16");
        scenario.phone("5550101").say("sms " + NUMBER + " hello").expect("sms-delivered");
        type(linphone, "quit");
        gateway.expect("left", "number", NUMBER);
    }

    private static void type(Process program, String line) throws IOException {
        program.getOutputStream().write((line + "\n").getBytes(StandardCharsets.US_ASCII));
        program.getOutputStream().flush();
    }

    // pjsua

    @Test
    void pjsuaRegistersCallsKeysByEventsAndInfoSendsAMessageAndIsCalled() throws Exception {
        Peer.PYTHON.require();
        Peer.require(Peer.PYTHON.run("-c", "import pjsua2").status() == 0, "pjsua2 (Python)");
        RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
        RunningProgram gateway = gateway();
        Process pjsua = Peer.PYTHON
                .process(
                        Peer.source("sip/pjsua2_calls.py"),
                        String.valueOf(port),
                        String.valueOf(freePorts()),
                        NUMBER,
                        "secret",
                        Scenario.ROBOT,
                        KEYS)
                .start();
        phones.add(pjsua);
        printed = new PrintedLines(pjsua);
        printed.await("registered 200");
        gateway.expect("joined", "kind", "sip", "number", NUMBER);
        for (int call = 0; call < 2; call++) {
            type(pjsua, "call");
            robot.expect("tone", "key", "1");
            type(pjsua, "key");
            for (char key : KEYS.toCharArray()) {
                robot.expectNext("keys", "keys", String.valueOf(key));
                type(pjsua, "next");
            }
            robot.expect("order", "text", KEYS, "verdict", "accepted");
            robot.expect("released", "cause", "16");
        }
        type(pjsua, "message");
        printed.await("sent 202");
        robot.expect("order", "text", KEYS, "verdict", "accepted");
        printed.await("message 3 Done: #**20.");

        RunningProgram phone = scenario.phone("5550101");
        phone.say("dial " + NUMBER);
        printed.await("incoming");
        phone.expect("connected", "number", NUMBER);
        phone.say("hangup");
        phone.expect("released", "cause", "16");
    }

    // SIPp

    private void pcap() throws Exception {
        Peer.PYTHON
                .run(
                        Peer.source("sip/events.py"),
                        folder.resolve("order96.pcap").toString(),
                        "96",
                        KEYS)
                .expectSuccess();
    }

    private Peer.Output sipp(String scenarioFile, int calls, int to, int perSecond) throws Exception {
        Path own = folder.resolve(scenarioFile);
        Files.copy(Path.of(Peer.source("sip/" + scenarioFile)), own);
        int ports = freePorts();
        ProcessBuilder builder = Peer.SIPP.process(
                "-sf",
                own.toString(),
                "-inf",
                folder.resolve("users.csv").toString(),
                "-i",
                "127.0.0.1",
                "-p",
                String.valueOf(ports),
                "-mp",
                String.valueOf(ports + 4),
                "-m",
                String.valueOf(calls),
                "-r",
                String.valueOf(perSecond),
                "-nostdin",
                "-aa",
                "-recv_timeout",
                "40000",
                "-trace_err",
                "-error_file",
                folder.resolve("errors").toString(),
                "127.0.0.1:" + to);
        return Peer.run(builder.directory(folder.toFile()));
    }

    private void users(int count) throws IOException {
        List<String> lines = new ArrayList<>(List.of("SEQUENTIAL"));
        for (int i = 0; i < count; i++) {
            String number = String.valueOf(Integer.parseInt(NUMBER) + i);
            lines.add(number + ";[authentication username=" + number + " password=secret];"
                    + (Integer.parseInt(Scenario.ROBOT) + 1000 + i));
        }
        Files.write(folder.resolve("users.csv"), lines);
    }

    @ParameterizedTest
    @ValueSource(strings = {"info.xml", "order.xml"})
    void sippKeysByInfoAndByEvents(String file) throws Exception {
        Peer.SIPP.require();
        pcap();
        users(1);
        RunningProgram robot = scenario.robot("empty.map", "--speed", "10", "--robot", "robot0=5551200");
        gateway();
        Peer.Output output = sipp(file, 1, port, 1);
        assertEquals(0, output.status(), output::text);
        robot.expect("order", "text", KEYS, "verdict", "accepted");
    }

    /** 200 calls at 10 a second; 5 % of all datagrams, SIP and speech, are lost in both directions. */
    @Test
    void noOrderOfManyLossyCallsIsWrongOrDoubled() throws Exception {
        Peer.SIPP.require();
        pcap();
        users(CALLS);
        RunningProgram robots = scenario.robot(
                "empty.map",
                IntStream.range(0, CALLS)
                        .boxed()
                        .flatMap(i -> Stream.of("--robot", "robot" + i + "=" + (5551200 + i)))
                        .toArray(String[]::new));
        for (int i = 1; i < CALLS; i++) {
            robots.expect("registered");
        }
        RunningProgram gateway = scenario.sipGateway(IntStream.range(0, CALLS)
                .mapToObj(i -> String.valueOf(Integer.parseInt(NUMBER) + i))
                .toList());
        int gatewayPort = Integer.parseInt(gateway.expect("ready").field("sip"));
        try (LossyRelay relay = new LossyRelay(gatewayPort, LOSS)) {
            Peer.Output output = sipp("order.xml", CALLS, relay.port(), 10);
            Map<String, String> orders = new TreeMap<>();
            for (ConsoleEvent event : robots.allSaid("order")) {
                orders.merge(event.field("robot"), event.field("text") + event.field("verdict"), (a, b) -> a + " " + b);
            }
            String kinds = orders.values().stream()
                    .collect(Collectors.groupingBy(text -> text, TreeMap::new, Collectors.counting()))
                    .toString();
            System.out.printf(
                    "  %d calls, %d datagrams passed, %d lost: %s; SIPp %d%n",
                    CALLS, relay.passed.get(), relay.lost.get(), kinds, output.status());
            assertEquals("{" + KEYS + "accepted=" + orders.size() + "}", kinds, output::text);
            assertTrue(orders.size() >= CALLS * 9 / 10, kinds + output.text());
        }
    }
}
