package simgsm.tools;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.tools.audio.WholeSpeechFile;

class ToolsMainTest {
    @TempDir
    Path folder;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String... words) {
        out.reset();
        err.reset();
        try (PrintStream printed = new PrintStream(out, true, StandardCharsets.UTF_8);
                PrintStream complained = new PrintStream(err, true, StandardCharsets.UTF_8)) {
            return ToolsMain.run(List.of(words), printed, complained);
        }
    }

    private String out() {
        return out.toString(StandardCharsets.UTF_8);
    }

    private String err() {
        return err.toString(StandardCharsets.UTF_8);
    }

    private String file(String name) {
        return folder.resolve(name).toString();
    }

    @Test
    void whatTonesWritesDecodeReads() {
        assertEquals(0, run("tones", "**#**20**", file("a.wav")));
        assertEquals("", out());
        assertEquals(0, run("decode", file("a.wav")));
        String[] fields = out().split("\t", -1);
        assertEquals(file("a.wav"), fields[0]);
        assertEquals("**#**20**", fields[1]);
        String[] times = fields[2].strip().split(",");
        assertEquals(9, times.length);
        for (int i = 0; i < 9; i++) {
            int delay = Integer.parseInt(times[i]) - 200 * i;
            assertTrue(delay >= 23 && delay <= 33, "decided after " + delay + " ms");
        }
    }

    @Test
    void tonesLast100MillisecondsEachByDefault() throws IOException {
        run("tones", "1 2", file("a.wav"));
        assertEquals(2 * 200 * 8, WholeSpeechFile.read(folder.resolve("a.wav")).length);
        run("tones", "--tone-ms=50", "12", "--pause-ms", "40", file("b.wav"), "--level", "-20.5");
        short[] samples = WholeSpeechFile.read(folder.resolve("b.wav"));
        assertEquals(2 * 90 * 8, samples.length);
        int peak = 0;
        for (short sample : samples) {
            peak = Math.max(peak, sample);
        }
        assertTrue(peak < 2 * 2156 && peak > 3800, "peak " + peak);
    }

    @Test
    void decodePrintsOneLinePerFileAndSaysWhichAreNoAudio() throws IOException {
        run("tones", "5", file("a.wav"));
        Files.writeString(folder.resolve("b.txt"), "no audio");
        assertEquals(1, run("decode", file("b.txt"), file("a.wav")));
        String[] lines = out().split("\n");
        assertEquals(2, lines.length);
        assertEquals(file("b.txt") + "\t\t", lines[0]);
        assertTrue(lines[1].startsWith(file("a.wav") + "\t5\t"), lines[1]);
        assertTrue(err().contains("b.txt"), err());
    }

    @Test
    void manyFilesComeOutInTheOrderInWhichTheyWereNamed() {
        String keys = "0123456789*#ABCD";
        String[] words = new String[41];
        words[0] = "decode";
        for (int i = 1; i < words.length; i++) {
            words[i] = file(i + ".wav");
            run("tones", keys.substring(i % 16).repeat(1 + 7 * (i % 3)), words[i]);
        }
        assertEquals(0, run(words));
        String[] lines = out().split("\n");
        assertEquals(40, lines.length);
        for (int i = 1; i < words.length; i++) {
            String expected = words[i] + "\t" + keys.substring(i % 16).repeat(1 + 7 * (i % 3)) + "\t";
            assertTrue(lines[i - 1].startsWith(expected), lines[i - 1]);
        }
    }

    @Test
    void aMissingFileIsAnInputOutputError() {
        assertEquals(74, run("decode", file("missing.wav")));
        assertEquals(file("missing.wav") + "\t\t\n", out());
        assertTrue(err().contains("no such file"), err());
    }

    @Test
    void aPlaceThatCannotBeWrittenIsAnInputOutputError() {
        assertEquals(74, run("tones", "1", file("no/such/folder.wav")));
        assertEquals("", out());
    }

    @Test
    void speechGoesThroughGsmAndBackWithItsKeys() throws IOException {
        run("tones", "159D", file("a.wav"), "--pause-ms", "110");
        assertEquals(0, run("gsm", "encode", file("a.wav"), file("a.gsm")));
        assertEquals(42 * 33, Files.size(folder.resolve("a.gsm")));
        assertEquals(0, run("gsm", "decode", file("a.gsm"), file("b.wav")));
        assertEquals(42 * 160, WholeSpeechFile.read(folder.resolve("b.wav")).length);
        run("decode", file("b.wav"));
        assertTrue(out().contains("\t159D\t"), out());
    }

    @Test
    void decodeReadsGsmFramesBothPlainAndInAWavFileAndFromStandardInput() throws IOException {
        run("tones", "159D", file("a.wav"), "--pause-ms", "110");
        run("gsm", "encode", file("a.wav"), file("a.gsm"));
        byte[] frames = Files.readAllBytes(folder.resolve("a.gsm"));
        Files.write(folder.resolve("49.wav"), wav(49, 1, 65, gsmInWav(frames)));
        assertEquals(0, run("decode", file("a.gsm"), file("49.wav")));
        assertTrue(out().contains("a.gsm\t159D\t") && out().contains("49.wav\t159D\t"), out());
        InputStream before = System.in;
        System.setIn(new ByteArrayInputStream(frames));
        try {
            assertEquals(0, run("decode", "-"));
            assertTrue(out().startsWith("-\t159D\t"), out());
        } finally {
            System.setIn(before);
        }
        frames[66] = 0;
        Files.write(folder.resolve("a.gsm"), frames);
        assertEquals(1, run("decode", file("a.gsm")));
        assertTrue(err().contains("a.gsm"), err());
    }

    /** Two frames a block, bit by bit from the least significant bit of each parameter (the widths of ETS 300 961, table 1.1). */
    private static byte[] gsmInWav(byte[] frames) {
        int[] ratios = {6, 6, 5, 5, 4, 4, 3, 3};
        int[] subframe = {7, 2, 2, 6, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
        BitSet bits = new BitSet();
        int to = 0;
        for (int frame = 0; frame < frames.length; frame += 33) {
            int from = 8 * frame + 4;
            for (int k = 0; k < 8 + 4 * 17; k++) {
                int width = k < 8 ? ratios[k] : subframe[(k - 8) % 17];
                for (int i = 0; i < width; i++, to++) {
                    int source = from + width - 1 - i;
                    bits.set(to, (frames[source >> 3] >> 7 - (source & 7) & 1) == 1);
                }
                from += width;
            }
        }
        return Arrays.copyOf(bits.toByteArray(), to / 520 * 65);
    }

    private static byte[] wav(int tag, int channels, int promised, byte[] sound) {
        ByteBuffer octets = ByteBuffer.allocate(44 + sound.length).order(ByteOrder.LITTLE_ENDIAN);
        octets.put("RIFF".getBytes(StandardCharsets.US_ASCII)).putInt(36 + sound.length);
        octets.put("WAVEfmt ".getBytes(StandardCharsets.US_ASCII)).putInt(16);
        octets.putShort((short) tag).putShort((short) channels).putInt(8000).putInt(16000);
        octets.putShort((short) 65).putShort((short) (tag == 1 ? 16 : 0));
        octets.put("data".getBytes(StandardCharsets.US_ASCII)).putInt(tag == 1 ? promised : sound.length);
        return octets.put(sound).array();
    }

    @Test
    void aFileThatIsShorterThanItsHeaderSaysOrHasTooManyChannelsEndsWith1() throws IOException {
        Files.write(folder.resolve("short.wav"), wav(1, 1, 51_200, new byte[10_000]));
        Files.write(folder.resolve("whole.wav"), wav(1, 1, 10_000, new byte[10_000]));
        Files.write(folder.resolve("pipe.wav"), wav(1, 1, -1, new byte[10_000]));
        Files.write(folder.resolve("many.wav"), wav(1, 65_535, 10_000, new byte[10_000]));
        assertEquals(1, run("decode", file("short.wav")));
        assertTrue(err().contains("short.wav: ends 41200 octets before its header says"), err());
        assertEquals(0, run("decode", file("whole.wav"), file("pipe.wav")), err());
        assertEquals(1, run("decode", file("many.wav")));
        assertTrue(err().contains("65535 channels"), err());
    }

    @Test
    void aHigherLimitRefusesKeysAndALowerOneDoesNot() {
        run("tones", "1", file("a.wav"), "--noise", "0");
        assertEquals(0, run("decode", "--limit", "100", file("a.wav")));
        assertEquals(file("a.wav") + "\t\t\n", out());
        assertEquals(0, run("decode", "--limit", "0", file("a.wav")));
        assertTrue(out().contains("\t1\t"), out());
        assertEquals(2, run("decode", "--limit", "much", file("a.wav")));
    }

    @Test
    void shortMessagesAreEncodedAPartALineAndDecodedInWords() {
        assertEquals(0, run("pdu", "encode", "hellohello"));
        assertEquals("0,0,10,e8329bfd4697d9ec37\n", out());
        assertEquals(0, run("pdu", "encode", "--ref", "a7", "x".repeat(161)));
        String[] parts = out().split("\n");
        assertEquals(2, parts.length);
        assertTrue(parts[0].startsWith("1,0,160,050003a70201"), parts[0]);
        assertTrue(parts[1].startsWith("1,0,15,050003a70202"), parts[1]);
        assertEquals(0, run("pdu", "decode", "01000B912143658709F200000AE8329BFD4697D9EC37"));
        assertTrue(out().contains("hellohello"), out());
    }

    @Test
    void aBrokenPduIsExplainedAndEndsWith1() {
        assertEquals(1, run("pdu", "decode", "0"));
        assertEquals(1, run("pdu", "decode", "01"));
        assertTrue(err().startsWith("simgsm-modem: pdu decode: "), err());
        assertEquals("", out());
        assertEquals(2, run("pdu", "encode", "--ref", "xyz", "text"));
        assertEquals(2, run("pdu", "shout", "text"));
    }

    @Test
    void gsmFilesThatAreDamagedEndWith1() throws IOException {
        Files.write(folder.resolve("a.gsm"), new byte[33]);
        assertEquals(1, run("gsm", "decode", file("a.gsm"), file("a.wav")));
        assertTrue(err().contains("octet 0"), err());
        run("tones", "1", file("b.wav"));
        run("gsm", "encode", file("b.wav"), file("b.gsm"));
        Files.write(folder.resolve("b.gsm"), java.util.Arrays.copyOf(Files.readAllBytes(folder.resolve("b.gsm")), 40));
        assertEquals(1, run("gsm", "decode", file("b.gsm"), file("c.wav")));
        assertEquals(160, WholeSpeechFile.read(folder.resolve("c.wav")).length);
    }

    @Test
    void wrongUseIsExplainedAndEndsWith2() {
        String wav = file("a.wav");
        List<String[]> wrong = List.of(
                new String[] {},
                new String[] {"sing"},
                new String[] {"tones"},
                new String[] {"tones", "1"},
                new String[] {"tones", "1", wav, "more"},
                new String[] {"tones", "12x", wav},
                new String[] {"tones", "1d", wav},
                new String[] {"tones", " ", wav},
                new String[] {"tones", "1", wav, "--tone-ms", "0"},
                new String[] {"tones", "1", wav, "--tone-ms", "ten"},
                new String[] {"tones", "1", wav, "--level", "4"},
                new String[] {"tones", "1", wav, "--level", "NaN"},
                new String[] {"tones", "1", wav, "--loud"},
                new String[] {"gsm"},
                new String[] {"gsm", "squeeze", wav, wav},
                new String[] {"gsm", "encode", wav},
                new String[] {"decode"},
                new String[] {"decode", "--fast", wav});
        for (String[] words : wrong) {
            assertEquals(2, run(words), String.join(" ", words));
            assertTrue(err().contains("--help"), err());
            assertEquals("", out());
        }
        assertTrue(Files.notExists(Path.of(wav)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"-h", "--help"})
    void helpGoesToStandardOutput(String option) {
        assertEquals(0, run(option));
        assertTrue(out().contains("tones KEYS OUT.wav"), out());
        assertTrue(out().contains("decode FILE.wav..."), out());
        assertEquals(0, run("tones", option));
        assertTrue(out().contains("--tone-ms"), out());
        assertEquals("", err());
    }

    @Test
    void versionNamesTheProgram() {
        assertEquals(0, run("-V"));
        assertTrue(out().startsWith("simgsm-modem "), out());
    }

    @Test
    void impossibleLoadsAreUsageErrors() {
        assertEquals(2, run("load", "--center", "127.0.0.1:1", "--phones", "3", "--calls", "2"));
        assertTrue(err().contains("--calls: expected 0 to 1"), err());
        assertEquals(2, run("load", "--center", "nowhere"));
        assertTrue(err().contains("--center: expected HOST:PORT"), err());
        assertEquals(2, run("load", "--sms", "many"));
        assertTrue(err().contains("--sms: expected a whole number"), err());
    }
}
