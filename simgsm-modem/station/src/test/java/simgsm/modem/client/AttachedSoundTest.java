package simgsm.modem.client;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.modem.CallDecision;
import simgsm.modem.line.ModemLine;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;

/** Keys and tones in the sound of a real modem's calls; the second line's frames are given by hand. */
class AttachedSoundTest {
    private static final int FRAME_SAMPLES = 160;

    /** Keys that the modem sends to the far end. */
    private final StringBuilder toldFar = new StringBuilder();

    private final DtmfReceiver farEnd =
            new DtmfReceiver(digit -> toldFar.append(digit.key().symbol()));
    private final List<String> recorded = new ArrayList<>();
    private final DtmfGenerator caller = new DtmfGenerator();
    private int framesSent;
    private UnaryOperator<short[]> treatment = UnaryOperator.identity();
    private final ModemBench bench = new ModemBench(1500, new SoundPort(this::fromRobot, new CallAudioListener() {
        @Override
        public void callBegan() {
            recorded.add("began");
        }

        @Override
        public void callEnded() {
            recorded.add("ended");
        }
    }));
    private final ModemLine.Party sound = bench.modem.sound();

    @BeforeEach
    void aHuaweiThatReportsNoKeys() {
        DtmfDialectAnswers.refuseAll(bench);
        bench.answers.put("AT^CVOICE?", "^CVOICE:0,8000,16,20|OK");
    }

    private void fromRobot(byte[] octets) {
        short[] samples = new short[octets.length / 2];
        ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(samples);
        framesSent++;
        farEnd.accept(samples);
    }

    /** The caller's sound as the modem hands it on, in pieces that do not fit to frames. */
    private void hear(int millis) {
        for (int frame = 0; frame < millis / 20; frame++) {
            short[] samples = new short[FRAME_SAMPLES];
            caller.read(samples);
            samples = treatment.apply(samples);
            ByteBuffer octets = ByteBuffer.allocate(2 * FRAME_SAMPLES).order(ByteOrder.LITTLE_ENDIAN);
            octets.asShortBuffer().put(samples);
            byte[] first = new byte[101];
            byte[] rest = new byte[2 * FRAME_SAMPLES - first.length];
            octets.get(first).get(rest);
            bench.millis(10);
            sound.received(first, bench.nowNanos);
            bench.millis(10);
            sound.received(rest, bench.nowNanos);
        }
    }

    private void press(String keys) {
        DtmfKey.sequence(keys).forEach(key -> caller.enqueue(key, 100, 100));
        hear(200 * keys.length() + 100);
    }

    private List<String> news() {
        return bench.news().stream()
                .filter(event -> !event.equals("SpeechReceived"))
                .toList();
    }

    private void openAndCall() {
        sound.lineUp(bench.nowNanos);
        bench.ready().inCall();
        hear(500);
        bench.news();
    }

    @Test
    void keysAreHeardAndTonesSentInTheSoundAtTheModemsPace() {
        openAndCall();
        assertTrue(bench.sent.contains("AT^DDSETEX=2"));
        assertEquals("1", toldFar.toString());
        press("**#9");
        assertEquals(
                List.of("key *", "key *", "key #", "key 9"),
                news().stream()
                        .filter(event -> event.startsWith("key "))
                        .map(event -> event.substring(0, 5))
                        .toList());
        int before = framesSent;
        assertTrue(bench.modem.sendTone(DtmfKey.of('6')));
        hear(400);
        assertEquals(20, framesSent - before);
        assertEquals("16", toldFar.toString());
        assertEquals(List.of("tone 6"), news());
        assertFalse(bench.sent.stream().anyMatch(command -> command.startsWith("AT+VTS=1")));
        bench.say("NO CARRIER");
        assertEquals(List.of("began", "ended"), recorded);
        assertEquals(List.of("released 16"), news());
    }

    /** 16 dB below the two tones together, through GSM 06.10. */
    @Test
    void aThousandKeysInNoiseThroughGsmFullRateAreHeardOnce() {
        openAndCall();
        Random random = new Random(6);
        SpeechCodec codec = SpeechCodec.Kind.GSM_FULL_RATE.open();
        double sigma = 32768 * Math.pow(10, (-3.14 - 7 - 16) / 20) / Math.sqrt(2);
        treatment = frame -> {
            for (int i = 0; i < frame.length; i++) {
                frame[i] += (short) Math.rint(sigma * random.nextGaussian());
            }
            return codec.decode(codec.encode(frame));
        };
        StringBuilder keys = new StringBuilder();
        StringBuilder heard = new StringBuilder();
        for (int block = 0; block < 50; block++) {
            String pressed = random.ints(20, 0, 12)
                    .mapToObj(i -> "0123456789*#".substring(i, i + 1))
                    .collect(joining());
            keys.append(pressed);
            press(pressed);
            news().stream().filter(event -> event.startsWith("key ")).forEach(event -> heard.append(event.charAt(4)));
        }
        assertEquals(keys.toString(), heard.toString());
    }

    @Test
    void sixtySecondsWithoutAKeyInTheSoundEndTheCall() {
        openAndCall();
        hear(58_000);
        press("5");
        hear(58_000);
        assertFalse(news().contains("CallIdle"));
        hear(3_000);
        assertEquals(List.of("CallIdle", "released 16"), news());
    }

    @Test
    void aDeniedCallerHearsTheToneAndIsHungUp() {
        bench.decision = new CallDecision(false, DtmfKey.of('2'));
        sound.lineUp(bench.nowNanos);
        bench.ready().inCall();
        hear(500);
        assertEquals("2", toldFar.toString());
        assertEquals("ATH", bench.lastSent().orElseThrow());
        assertEquals(List.of("StationRegistered", "ringing 5550100", "tone 2", "released 16"), news());
    }

    @ParameterizedTest
    @CsvSource({
        "AT^CVOICE?, ^CVOICE:0|OK, AT^DDSETEX=2",
        "AT^CVOICE?, ^CVOICE:1|OK, none",
        "AT+CPCMREG=?, +CPCMREG: (0-1)|OK, AT+CPCMREG=1",
        "AT+QPCMV=?, '+QPCMV: (0,1),(0-2)|OK', 'AT+QPCMV=1,0'",
    })
    void theCommandForTheSoundIsChosenByWhatTheModemAnswers(String question, String answer, String command) {
        bench.answers.put("AT^CVOICE?", "ERROR");
        bench.answers.put(question, answer);
        openAndCall();
        assertEquals(
                command.equals("none") ? List.of() : List.of(command),
                bench.sent.stream()
                        .filter(sent -> sent.matches("AT(\\^DDSETEX|\\+CPCMREG=1|\\+QPCMV=1).*"))
                        .toList());
    }

    @Test
    void reportedKeysCountOnlyWhileThereIsNoSound() {
        DtmfDialectAnswers.acceptAll(bench);
        openAndCall();
        bench.say("+DTMF: 5");
        press("5");
        assertEquals(
                1, news().stream().filter(event -> event.startsWith("key 5")).count());
        bench.modem.sendTone(DtmfKey.of('3'));
        sound.lineDown(bench.nowNanos);
        assertEquals(List.of("KeyUnreadable"), news());
        assertEquals("ready TestNet; no sound: the line of the sound is lost", bench.states.get(1));
        bench.say("+DTMF: 7");
        bench.millis(600);
        assertEquals(List.of("key 7 0.0", "KeyEnded", "tone 3"), news());
        assertTrue(bench.sent.contains("AT+VTS=3"));
        sound.lineUp(bench.nowNanos);
        assertEquals("ready TestNet", bench.states.get(2));
        hear(100);
        assertEquals(List.of("KeyUnreadable"), news());
        press("8");
        assertTrue(news().get(0).startsWith("key 8"));
    }

    @Test
    void aCallWhoseKeysCannotBeHeardAnyMoreIsLost() {
        openAndCall();
        bench.millis(400);
        assertEquals(List.of(), news());
        bench.millis(200);
        assertEquals(List.of("KeyUnreadable", "released 41"), news());
        assertEquals("ATH", bench.lastSent().orElseThrow());
    }

    @Test
    void withoutSoundAndReportedKeysCallsAreRefused() {
        sound.lineFailed("no such file");
        bench.ready().inCall();
        assertEquals(List.of("StationRegistered", "ringing 5550100", "released 16"), news());
        assertEquals(List.of("ready TestNet; no sound: no such file"), bench.states);
        assertTrue(Stream.of("ATA").noneMatch(bench.sent::contains));
    }

    /** The answers to the commands that enable reported keys. */
    static final class DtmfDialectAnswers {
        static void refuseAll(ModemBench bench) {
            commands().forEach(command -> bench.answers.put(command, "ERROR"));
        }

        static void acceptAll(ModemBench bench) {
            commands().forEach(bench.answers::remove);
            bench.answers.put("AT+DDET?", "+DDET: 1,0,1,0|OK");
        }

        private static Stream<String> commands() {
            return Stream.concat(
                    Stream.of(DtmfDialect.values()).flatMap(dialect -> dialect.enablers().stream()),
                    Stream.of("AT+DDET?", "AT+CPCMREG=?", "AT+QPCMV=?"));
        }
    }
}
