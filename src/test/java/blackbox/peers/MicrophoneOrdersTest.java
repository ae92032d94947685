package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import blackbox.RunningProgram;
import blackbox.Scenario;
import blackbox.SpokenWords;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * Words that a sound server gives to the phone's {@code --microphone}: what is played into a device is recorded there. The
 * phone itself plays nothing, as the device would record its tones, too.
 */
@Tag("peer")
@Isolated("sound in real time through a server")
class MicrophoneOrdersTest {
    private static final int PATIENCE_SECONDS = 60;

    @TempDir
    Path folder;

    private Map<String, String> environment = Map.of();
    private Process server;

    @BeforeEach
    void startServer() throws Exception {
        for (Peer peer : List.of(Peer.PULSEAUDIO, Peer.PACTL, Peer.PAPLAY)) {
            peer.require();
        }
        Path home = Files.createDirectory(folder.resolve("home"));
        Path runtime = Files.createDirectory(
                folder.resolve("run"),
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
        Files.writeString(home.resolve(".asoundrc"), "pcm.!default { type pulse }\nctl.!default { type pulse }\n");
        String socket = runtime.resolve("native").toString();
        environment = Map.of(
                "HOME", home.toString(),
                "XDG_RUNTIME_DIR", runtime.toString(),
                "PULSE_COOKIE", runtime.resolve("cookie").toString(),
                "PULSE_SERVER", "unix:" + socket,
                "PULSE_SOURCE", "mouth.monitor");
        server = inside(Peer.PULSEAUDIO.process(
                        "-n",
                        "--daemonize=no",
                        "--exit-idle-time=-1",
                        "--use-pid-file=no",
                        "-L",
                        "module-native-protocol-unix auth-anonymous=1 socket=" + socket,
                        "-L",
                        "module-null-sink sink_name=mouth rate=8000 channels=1"))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        Peer.Output seen = Peer.run(inside(Peer.PACTL.process("info")));
        while (seen.status() != 0 && System.nanoTime() < deadline) {
            seen = Peer.run(inside(Peer.PACTL.process("info")));
        }
        seen.expectSuccess();
    }

    @AfterEach
    void end() throws InterruptedException {
        if (server != null) {
            server.destroy();
            server.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
    }

    private ProcessBuilder inside(ProcessBuilder builder) {
        builder.environment().putAll(environment);
        return builder;
    }

    private void speak(String... words) throws Exception {
        String file = SpokenWords.file(folder, words).toString();
        Peer.run(inside(Peer.PAPLAY.process("-d", "mouth", file))).expectSuccess();
    }

    @Test
    void anOrderSpokenIntoTheMicrophoneIsHeardReadBackAndConfirmedByAKey() throws Exception {
        try (Scenario scenario = new Scenario("a phone with a microphone")) {
            Path data = scenario.folder().resolve("robot-data");
            SpokenWords.enrol(data, scenario.folder());
            scenario.center();
            RunningProgram robot = scenario.robot("demo.map", "--voice", "--data", data.toString());
            RunningProgram phone = scenario.startJar(
                    "phone",
                    environment,
                    "simgsm-phone",
                    "--headless",
                    "--lang=en",
                    "--no-sound",
                    "--microphone",
                    "--center=" + scenario.centerAddress());
            phone.expect("registered");
            scenario.call(phone);
            phone.say("press ** #*0 **");
            phone.expect("words");
            phone.say("press *#");
            phone.expect("words", "text", "Say forward turn stop or status");
            speak("forward", "two", "zero");
            for (String word : List.of("forward", "two", "zero")) {
                assertEquals(word, robot.expect("heard", "verdict", "sure").field("word"));
            }
            phone.expect("words", "text", "Forward two zero say yes");
            phone.say("press #");
            assertEquals(
                    "**#**20**", robot.expect("order", "verdict", "accepted").field("text"));
            phone.expect("tone", "key", "3");
            assertFalse(phone.log().contains("WARNING"), phone.log());
        }
    }

    @Test
    void withoutAServerTheMissingMicrophoneIsSaidAndThePhoneEndsWith69() throws Exception {
        end();
        try (Scenario scenario = new Scenario("a phone without its microphone")) {
            RunningProgram phone =
                    scenario.startJar("phone", environment, "simgsm-phone", "--headless", "--microphone");
            assertEquals(69, phone.awaitExit());
            assertEquals(
                    "simgsm-phone: --microphone: no sound input of 8 kHz, 16 bit, mono",
                    phone.log().strip().replaceFirst("mono: .*", "mono"));
        }
    }
}
