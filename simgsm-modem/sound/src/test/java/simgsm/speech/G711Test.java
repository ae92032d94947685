package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioFormat.Encoding;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class G711Test {
    private static G711 codec(SpeechCodec.Kind kind) {
        return (G711) kind.open();
    }

    @Test
    void theCharacterSignalsOfG711Table5And6AreASineOf0Dbm0() {
        // G.711, tables 5 and 6: these eight octets, repeated, are a 1 kHz sine at 0 dBm0.
        int[] aLaw = {0x34, 0x21, 0x21, 0x34, 0xB4, 0xA1, 0xA1, 0xB4};
        int[] muLaw = {0x1E, 0x0B, 0x0B, 0x1E, 0x9E, 0x8B, 0x8B, 0x9E};
        assertEquals(0, level(codec(SpeechCodec.Kind.A_LAW), aLaw), 0.01);
        assertEquals(0, level(codec(SpeechCodec.Kind.MU_LAW), muLaw), 0.05);
    }

    /** Against 3.14 (A-law) or 3.17 (mu-law) dBm0 for a full-scale sine. */
    private static double level(G711 codec, int[] octets) {
        double power = 0;
        for (int octet : octets) {
            double sample = codec.expand((byte) octet);
            power += sample * sample / octets.length;
        }
        double fullScale = codec.kind() == SpeechCodec.Kind.A_LAW ? 32768 : 8159 * 4;
        double reference = codec.kind() == SpeechCodec.Kind.A_LAW ? 3.14 : 3.17;
        return reference + 10 * Math.log10(2 * power / fullScale / fullScale);
    }

    private static byte compress(G711 codec, short sample) {
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        frame[0] = sample;
        return codec.encode(frame)[0];
    }

    @ParameterizedTest
    @EnumSource(names = {"A_LAW", "MU_LAW"})
    void everyOctetSurvivesTheWayThere(SpeechCodec.Kind kind) {
        G711 codec = codec(kind);
        for (int octet = 0; octet < 256; octet++) {
            byte back = compress(codec, codec.expand((byte) octet));
            // Mu-law has two zeros; the negative one (0x7F) comes back as the positive.
            int expected = kind == SpeechCodec.Kind.MU_LAW && octet == 0x7F ? 0xFF : octet;
            assertEquals(expected, back & 0xFF);
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"A_LAW", "MU_LAW"})
    void noSampleIsOffByMoreThanHalfItsStep(SpeechCodec.Kind kind) {
        G711 codec = codec(kind);
        int[] levels = new int[256];
        for (int octet = 0; octet < 256; octet++) {
            levels[octet] = codec.expand((byte) octet);
        }
        Arrays.sort(levels);
        int clip = levels[255];
        int before = Short.MIN_VALUE;
        for (int sample = Short.MIN_VALUE; sample <= Short.MAX_VALUE; sample++) {
            int level = codec.expand(compress(codec, (short) sample));
            assertTrue(level >= before, "not monotonic at " + sample);
            before = level;
            int at = Arrays.binarySearch(levels, level);
            int step = Math.max(at > 0 ? level - levels[at - 1] : 0, at < 255 ? levels[at + 1] - level : 0);
            // Samples are coded with 13 or 14 bits beforehand, which may cost 8.
            int error = Math.abs(level - sample);
            assertTrue(error <= step / 2 + 8 || Math.abs(sample) > clip, sample + " is off by " + error);
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"A_LAW", "MU_LAW"})
    void theJdkExpandsTheSame(SpeechCodec.Kind kind) throws IOException {
        byte[] octets = new byte[256];
        for (int i = 0; i < 256; i++) {
            octets[i] = (byte) i;
        }
        Encoding encoding = kind == SpeechCodec.Kind.A_LAW ? Encoding.ALAW : Encoding.ULAW;
        AudioInputStream in = new AudioInputStream(
                new ByteArrayInputStream(octets), new AudioFormat(encoding, 8000, 8, 1, 1, 8000, false), 256);
        byte[] pcm = AudioSystem.getAudioInputStream(new AudioFormat(8000, 16, 1, true, false), in)
                .readAllBytes();
        for (int i = 0; i < 256; i++) {
            int jdk = (short) (pcm[2 * i] & 0xFF | pcm[2 * i + 1] << 8);
            assertEquals(jdk, codec(kind).expand((byte) i), "octet " + i);
        }
    }

    @Test
    void aFrameIs160OctetsAndComesBackAlmostWhole() {
        short[] frame = new short[160];
        for (int i = 0; i < 160; i++) {
            frame[i] = (short) (8000 * Math.sin(i * 0.3));
        }
        SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
        byte[] octets = codec.encode(frame);
        assertEquals(SpeechCodec.Kind.A_LAW.octetsPerFrame(), octets.length);
        short[] back = codec.decode(octets);
        for (int i = 0; i < 160; i++) {
            assertEquals(frame[i], back[i], 256);
        }
        assertArrayEquals(octets, codec.encode(back));
    }

    @Test
    void framesOfAnotherLengthAreRefused() {
        SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
        assertThrows(IllegalArgumentException.class, () -> codec.decode(new byte[159]));
        assertThrows(IllegalArgumentException.class, () -> codec.encode(new short[161]));
    }

    @Test
    void aFrameIsSilentWithoutASampleAboveTheLimit() {
        assertTrue(SpeechCodec.isSilent(new short[] {0, 8, -8}, 8));
        assertFalse(SpeechCodec.isSilent(new short[] {0, 0, -9}, 8));
    }
}
