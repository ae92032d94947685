package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** Keys that are held at the phone's window, as a sound server plays them: its device plays into nothing and is recorded. */
@Tag("peer")
@Isolated("sound in real time through a server and a window")
class HeardKeysTest {
    private static final int SAMPLES_PER_MILLI = 8;
    private static final int PATIENCE_SECONDS = 60;
    /** Far below a tone, above the rounding of resamplers. */
    private static final int AUDIBLE = 30;

    private static final int HOLE_MILLIS = 3;
    /** ES 201 235-3 bridges shorter gaps of a tone. */
    private static final int BRIDGED_MILLIS = 20;

    private static final int FIRST_LATER_MILLIS = 40;
    /** The pause after a key is longer than this; a hole is shorter. */
    private static final int PAUSE_MILLIS = 200;

    private static final String CHAIN_KEY = "keydown %1$s sleep 0.5 keyup %1$s sleep 0.4 ";

    @TempDir
    Path folder;

    private final List<Process> running = new ArrayList<>();
    private Map<String, String> environment = Map.of();
    private Process server;

    /** When a key was heard first, how long, both in ms, and the holes in all of them. */
    private record Heard(List<Double> beginsMillis, List<Double> lengthsMillis, List<Double> holesMillis) {
        static Heard in(short[] samples) {
            Heard heard = new Heard(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
            int begin = -1;
            int last = -1;
            for (int i = 0; i <= samples.length; i++) {
                boolean sounds = i < samples.length && Math.abs(samples[i]) > AUDIBLE;
                boolean keyIsOver = i == samples.length || sounds && i - last > PAUSE_MILLIS * SAMPLES_PER_MILLI;
                if (begin >= 0 && keyIsOver) {
                    heard.beginsMillis.add(begin / (double) SAMPLES_PER_MILLI);
                    heard.lengthsMillis.add((last - begin) / (double) SAMPLES_PER_MILLI);
                    begin = -1;
                } else if (begin >= 0 && sounds && i - last > HOLE_MILLIS * SAMPLES_PER_MILLI) {
                    heard.holesMillis.add((i - last) / (double) SAMPLES_PER_MILLI);
                }
                if (sounds) {
                    begin = begin < 0 ? i : begin;
                    last = i;
                }
            }
            return heard;
        }

        boolean isWhole() {
            return beginsMillis.size() > 2 && holesMillis.size() <= 1 && firstIsLaterMillis() <= FIRST_LATER_MILLIS;
        }

        /** A longer hole makes one key two. */
        boolean isReadable() {
            return isWhole() && holesMillis.stream().allMatch(millis -> millis <= BRIDGED_MILLIS);
        }

        /** How much later the first key is heard than it would be at the others' distance. */
        double firstIsLaterMillis() {
            List<Double> distances = IntStream.range(1, beginsMillis.size())
                    .mapToObj(i -> beginsMillis.get(i) - beginsMillis.get(i - 1))
                    .toList();
            return distances.stream()
                            .skip(1)
                            .sorted()
                            .skip(distances.size() / 2 - 1)
                            .findFirst()
                            .orElseThrow()
                    - distances.get(0);
        }
    }

    @BeforeEach
    void desktop() throws Exception {
        for (Peer peer : List.of(Peer.XVFB, Peer.OPENBOX, Peer.XDOTOOL, Peer.PULSEAUDIO, Peer.PACTL, Peer.PAREC)) {
            peer.require();
        }
        Path home = Files.createDirectory(folder.resolve("home"));
        Path runtime = Files.createDirectory(
                folder.resolve("run"),
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
        Files.writeString(home.resolve(".asoundrc"), "pcm.!default { type pulse }\nctl.!default { type pulse }\n");
        // Xvfb complains of displays that are taken; only the number of its own belongs to standard output.
        Process screen = start(Peer.XVFB
                .process("-displayfd", "1", "-screen", "0", "1024x768x24", "-noreset", "-nolisten", "tcp")
                .redirectErrorStream(false)
                .redirectError(ProcessBuilder.Redirect.DISCARD));
        String display = ":"
                + new BufferedReader(new InputStreamReader(screen.getInputStream(), StandardCharsets.UTF_8)).readLine();
        environment = Map.of(
                "DISPLAY", display,
                "HOME", home.toString(),
                "XDG_RUNTIME_DIR", runtime.toString(),
                "PULSE_COOKIE", runtime.resolve("cookie").toString(),
                "PULSE_SERVER", "unix:" + runtime.resolve("native"));
        start(inside(Peer.OPENBOX.process()).redirectOutput(ProcessBuilder.Redirect.DISCARD));
        look(Peer.XDOTOOL, "get_num_desktops");
        startServer();
    }

    @AfterEach
    void end() throws InterruptedException {
        for (int i = running.size() - 1; i >= 0; i--) {
            running.get(i).destroy();
            running.get(i).waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
    }

    private void startServer() throws Exception {
        server = start(inside(Peer.PULSEAUDIO.process(
                        "-n",
                        "--daemonize=no",
                        "--exit-idle-time=-1",
                        "--use-pid-file=no",
                        "-L",
                        "module-native-protocol-unix auth-anonymous=1 socket="
                                + environment.get("PULSE_SERVER").substring("unix:".length()),
                        "-L",
                        "module-null-sink sink_name=ear rate=8000 channels=1"))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD));
        look(Peer.PACTL, "info");
    }

    private Process start(ProcessBuilder builder) throws Exception {
        Process process = builder.start();
        running.add(process);
        return process;
    }

    private ProcessBuilder inside(ProcessBuilder builder) {
        builder.environment().putAll(environment);
        return builder;
    }

    /** Looks again while a tool fails. */
    private String look(Peer peer, String... words) throws Exception {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        Peer.Output seen = Peer.run(inside(peer.process(words)));
        while (seen.status() != 0 && System.nanoTime() < deadline) {
            seen = Peer.run(inside(peer.process(words)));
        }
        return seen.expectSuccess();
    }

    private void awaitStream(String kind) throws Exception {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (look(Peer.PACTL, "list", "short", kind).isBlank()) {
            assertTrue(System.nanoTime() < deadline, "no " + kind);
        }
    }

    private RunningProgram phoneWithWindow(Scenario scenario) throws Exception {
        RunningProgram phone = scenario.startJar(
                "phone",
                environment,
                "simgsm-phone",
                "--console",
                "--fresh",
                "--lang=en",
                "--center=" + scenario.centerAddress());
        phone.expect("registered");
        String window = look(Peer.XDOTOOL, "search", "--sync", "--onlyvisible", "--name", "^Sim Cellular")
                .lines()
                .findFirst()
                .orElseThrow();
        look(Peer.XDOTOOL, "windowactivate", "--sync", window);
        awaitStream("sink-inputs");
        return phone;
    }

    private void hold(String keys) throws Exception {
        StringBuilder chain = new StringBuilder("sleep 0.5 ");
        keys.chars().forEach(key -> chain.append(CHAIN_KEY.formatted((char) key)));
        look(Peer.XDOTOOL, (chain + "sleep 0.5").split(" "));
    }

    /** Holds the keys one after the other and checks that the recording has just them. */
    private Heard hear(String keys) throws Exception {
        Path raw = folder.resolve(keys + ".raw");
        Process recorder = start(inside(Peer.PAREC.process(
                        "-d",
                        "ear.monitor",
                        "--format=s16le",
                        "--rate=8000",
                        "--channels=1",
                        "--latency-msec=20",
                        "--raw"))
                .redirectErrorStream(false)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .redirectOutput(raw.toFile()));
        awaitStream("source-outputs");
        hold(keys);
        recorder.destroy();
        recorder.waitFor();
        String decoded = Audio.tool(
                "decode",
                Audio.wav(folder.resolve("heard.wav"), Files.readAllBytes(raw)).toString());
        Heard heard = Heard.in(Sound.read(raw));
        System.out.println("  " + heard);
        if (heard.isReadable()) {
            assertEquals(keys, decoded.strip().split("\t")[1]);
        }
        return heard;
    }

    private Heard hearAtFreshPhone(String keys) throws Exception {
        try (Scenario scenario = new Scenario("keys at a phone with a window and a sound server")) {
            scenario.center();
            RunningProgram phone = phoneWithWindow(scenario);
            Heard heard = hear(keys);
            assertEquals("", phone.log());
            return heard;
        }
    }

    /** A machine that is busy for longer than the cushion makes holes, too, but not in each of three series. */
    @Test
    void twentyHeldKeysAreHeardWithoutHolesAndTheFirstAsSoonAsTheOthers() throws Exception {
        List<Heard> series = new ArrayList<>();
        while (series.size() < 3 && series.stream().noneMatch(Heard::isWhole)) {
            series.add(hearAtFreshPhone("57891203456789012345"));
        }
        assertTrue(series.get(series.size() - 1).isWhole(), series.toString());
    }

    @Test
    void aSoundServerThatEndsInACallIsSaidOnceAndPlaysTheCallOnceItIsBack() throws Exception {
        try (Scenario scenario = new Scenario("a sound server is killed in a call")) {
            scenario.center();
            RunningProgram far = scenario.phone("5550102");
            RunningProgram phone = phoneWithWindow(scenario);
            phone.say("dial 5550102");
            far.expect("ringing");
            far.say("answer");
            phone.expect("connected");
            hear("147");
            server.destroyForcibly().waitFor();
            hold("25");
            far.expect("tone", "key", "2");
            far.expect("tone", "key", "5");
            startServer();
            awaitStream("sink-inputs");
            hear("369");
            far.expect("tone", "key", "9");
            assertTrue(phone.log().strip().endsWith("the sound device has gone; looked for again every 5000 ms"));
            assertEquals(1, phone.log().lines().count(), phone.log());
        }
    }
}
