package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class GsmFullRateTest {
    private static final int FRAMES = 250;

    /** Five seconds each; with the digests of what the reference implementation (libgsm 1.0.22) makes of them. */
    enum Sound {
        TONES("52161b361d5f5660", "cc02c98243a9ed58"),
        VOICE("ae3fb2e06b723f1a", "eabd6ace495e8d3a"),
        NOISE("722dbfa7c4118ad1", "e796bcd67a94bedc"),
        LOUD_SQUARES("0b766b717a082baa", "31fc07566281e301"),
        WHISPER("7c2304ca9b48e38c", "2dbc4eeacff331df"),
        SILENCE("a8d9ee12a9a022b8", "4a2d80b5f22362fc");

        final String encoded;
        final String decoded;

        Sound(String encoded, String decoded) {
            this.encoded = encoded;
            this.decoded = decoded;
        }

        short[] samples() {
            short[] samples = new short[FRAMES * 160];
            Random random = new Random(ordinal());
            double phase = 0;
            for (int i = 0; i < samples.length; i++) {
                phase += 2 * StrictMath.PI * (120 + 40 * StrictMath.sin(i * 0.0004)) / 8000;
                double value = switch (this) {
                    case TONES -> i % 1600 < 800 ? tones(i, i / 1600) : 0;
                    case VOICE -> voice(phase, i);
                    case NOISE -> 6000 * random.nextGaussian();
                    case LOUD_SQUARES -> (i / (3 + i / 4000)) % 2 == 0 ? 32767 : -32768;
                    case WHISPER -> 12 * random.nextGaussian();
                    case SILENCE -> 0;
                };
                samples[i] = (short) Math.max(-32768, Math.min(32767, Math.rint(value)));
            }
            return samples;
        }

        private static double tones(int i, int which) {
            double[] rows = {697, 770, 852, 941};
            double[] columns = {1209, 1336, 1477, 1633};
            double step = 2 * StrictMath.PI * i / 8000;
            return 7218 * (StrictMath.sin(step * rows[which % 4]) + StrictMath.sin(step * columns[which / 4 % 4]));
        }

        private static double voice(double phase, int i) {
            double value = 0;
            for (int h = 1; h < 24; h++) {
                double formant = 5 + 4 * StrictMath.sin(i * 0.0003);
                value += StrictMath.sin(h * phase) / (1 + (h - formant) * (h - formant) / 4);
            }
            return 4000 * value * (0.5 + 0.5 * StrictMath.sin(i * 0.0017));
        }
    }

    private static byte[] encode(short[] samples) {
        SpeechCodec codec = SpeechCodec.Kind.GSM_FULL_RATE.open();
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        for (int i = 0; i < samples.length; i += 160) {
            octets.writeBytes(codec.encode(Arrays.copyOfRange(samples, i, i + 160)));
        }
        return octets.toByteArray();
    }

    private static byte[] decode(byte[] octets) {
        SpeechCodec codec = SpeechCodec.Kind.GSM_FULL_RATE.open();
        ByteArrayOutputStream sound = new ByteArrayOutputStream();
        for (int i = 0; i < octets.length; i += 33) {
            sound.writeBytes(littleEndian(codec.decode(Arrays.copyOfRange(octets, i, i + 33))));
        }
        return sound.toByteArray();
    }

    private static byte[] littleEndian(short[] samples) {
        ByteBuffer buffer = ByteBuffer.allocate(2 * samples.length).order(ByteOrder.LITTLE_ENDIAN);
        buffer.asShortBuffer().put(samples);
        return buffer.array();
    }

    private static String digest(byte[] octets) throws NoSuchAlgorithmException {
        byte[] whole = MessageDigest.getInstance("SHA-256").digest(octets);
        return HexFormat.of().formatHex(whole, 0, 8);
    }

    @ParameterizedTest
    @EnumSource
    void bothDirectionsAreThoseOfTheReference(Sound sound) throws NoSuchAlgorithmException {
        byte[] octets = encode(sound.samples());
        assertEquals(FRAMES * 33, octets.length);
        assertEquals(sound.encoded, digest(octets));
        assertEquals(sound.decoded, digest(decode(octets)));
    }

    @Test
    void silenceBecomesTheKnownFrame() {
        // The frame of digital silence that GSM equipment sends, known from RTP traces.
        assertEquals(
                "d820a2e15a50004924924924500049249249245000492492492450004924924924",
                HexFormat.of().formatHex(encode(new short[160])));
    }

    @Test
    void damagedFramesAreRefused() {
        SpeechCodec codec = SpeechCodec.Kind.GSM_FULL_RATE.open();
        byte[] wrongSignature = new byte[33];
        wrongSignature[0] = (byte) 0xC8;
        assertThrows(IllegalArgumentException.class, () -> codec.decode(new byte[32]));
        assertThrows(IllegalArgumentException.class, () -> codec.decode(wrongSignature));
        assertThrows(IllegalArgumentException.class, () -> codec.encode(new short[159]));
    }
}
