package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import blackbox.ServedModem;
import blackbox.ServedSound;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code --modem-audio} on a pseudo-terminal of socat's, with sound that programs from elsewhere have treated. */
@Tag("peer")
class SerialSoundTest {
    private static final int KEYS = 1_000;
    /** The modem is the clock of its sound, so that the test need not wait for it. */
    private static final int TIMES_REAL_TIME = 4;
    /** Both tones together are at -7 dBm0. */
    private static final double NOISE_DBM0 = -7 - 16;

    @TempDir
    Path folder;

    private final Scenario scenario = new Scenario("the sound of a modem on a serial line");
    private final ServedModem modem = new ServedModem();
    private final ServedSound sound = new ServedSound();
    private Process soundLine;
    private RunningProgram robot;

    SerialSoundTest() throws Exception {}

    @AfterEach
    void end() throws Exception {
        scenario.close();
        modem.close();
        sound.close();
    }

    /** A robot in a call of a modem that reports no keys. */
    private void call() throws Exception {
        Peer.SOCAT.require();
        modem.happens(there -> there.deaf = true);
        modem.happens(there -> there.hasSound = true);
        Path device = scenario.folder().resolve("ttyM2");
        SerialModemTest.serialLine(scenario, modem.port(), device);
        Path soundDevice = scenario.folder().resolve("ttySound");
        soundLine = SerialModemTest.serialLine(scenario, sound.port(), soundDevice);
        robot = scenario.start(
                "robot",
                "simrobot",
                "--headless",
                "--no-sound",
                "--lang=en",
                "--answer-after=0",
                "--world=" + Scenario.world("empty.map"),
                "--modem=" + device,
                "--modem-audio=" + soundDevice);
        robot.expect("registered");
        modem.call(Scenario.PHONE);
        robot.expect("tone", "key", "1");
    }

    private String keysHeard() {
        modem.hangUp();
        StringBuilder keys = new StringBuilder();
        robot.expectAll("released").stream()
                .filter(event -> event.name().equals("keys"))
                .forEach(event -> keys.append(event.field("keys")));
        return keys.toString();
    }

    @Test
    void aThousandKeysThroughGsmFullRateInNoiseAreHeardOnce() throws Exception {
        Sound keys = new Sound(6);
        keys.silence(500);
        while (keys.keys.length() < KEYS) {
            keys.key(100, 100);
        }
        keys.silence(500);
        keys.addNoise(NOISE_DBM0, 0, keys.length());
        Path treated = Treatment.GSM.of(keys.write(folder.resolve("keys.raw")), Path.of("none"));
        call();
        sound.play(Sound.read(treated), TIMES_REAL_TIME);
        String heard = keysHeard();
        int missed = 0;
        int at = 0;
        for (char key : keys.keys.toString().toCharArray()) {
            boolean isHeard = at < heard.length() && heard.charAt(at) == key;
            at += isHeard ? 1 : 0;
            missed += isHeard ? 0 : 1;
        }
        scenario.tell(KEYS + " keys, " + heard.length() + " heard, " + missed + " missed");
        assertTrue(missed <= 1 && heard.length() <= KEYS, missed + " missed in " + heard);
    }

    @Test
    void recordedSpeechGivesNoKeyAndKeysBesideItAreHeard() throws Exception {
        Path speech = Prompts.SPANISH.sample(folder, 12);
        Sound keys = new Sound(7);
        keys.silence(500);
        while (keys.keys.length() < 100) {
            keys.key(100, 100);
        }
        keys.addSpeech(Sound.read(speech), -20, 0, keys.length());
        Path mixed = Treatment.GSM.of(keys.write(folder.resolve("mixed.raw")), Path.of("none"));
        call();
        sound.play(Sound.read(Treatment.GSM.of(speech, Path.of("none"))), TIMES_REAL_TIME);
        sound.play(Sound.read(mixed), TIMES_REAL_TIME);
        assertEquals(keys.keys.toString(), keysHeard());
    }

    @Test
    void aSecondLineThatVanishesIsToldAndACallWithoutReportedKeysIsEnded() throws Exception {
        call();
        sound.play(tones("** #**90 **"), 1);
        robot.expect("tone", "key", "3");
        soundLine.destroy();
        robot.expect("modem", "state", "ready");
        robot.expect("released", "cause", "41");
        assertTrue(sound.tonesHeard().startsWith("16"), sound.tonesHeard());
    }

    private short[] tones(String keys) throws Exception {
        Path wav = folder.resolve("tones.wav");
        Audio.tool("tones", keys, wav.toString());
        Path raw = folder.resolve("tones.raw");
        Peer.SOX.run((wav + " " + Sound.RAW + " " + raw).split(" ")).expectSuccess();
        return Sound.read(raw);
    }
}
