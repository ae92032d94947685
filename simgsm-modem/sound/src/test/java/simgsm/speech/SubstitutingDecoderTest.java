package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;

/** GSM 06.11 by its samples: repetition, weakening, silence, and what the tone receiver makes of it. */
class SubstitutingDecoderTest {
    private static final int FRAME = SpeechCodec.SAMPLES_PER_FRAME;

    /** A voice-like sound whose frames differ: harmonics of 130 Hz. */
    private static short[] voice(int frames) {
        short[] samples = new short[frames * FRAME];
        for (int i = 0; i < samples.length; i++) {
            double value = 0;
            for (int h = 1; h < 20; h++) {
                value += Math.sin(2 * Math.PI * 130 * h * i / 8000.0) / h;
            }
            samples[i] = (short) (4000 * value);
        }
        return samples;
    }

    private static byte[][] coded(SpeechCodec.Kind kind, short[] samples) {
        SpeechCodec coder = kind.open();
        byte[][] frames = new byte[samples.length / FRAME][];
        for (int i = 0; i < frames.length; i++) {
            frames[i] = coder.encode(Arrays.copyOfRange(samples, i * FRAME, (i + 1) * FRAME));
        }
        return frames;
    }

    private static double rootMeanSquare(short[] samples) {
        double sum = 0;
        for (short sample : samples) {
            sum += (double) sample * sample;
        }
        return Math.sqrt(sum / samples.length);
    }

    private static double decibels(short[] samples, double reference) {
        return 20 * Math.log10(Math.max(1, rootMeanSquare(samples)) / reference);
    }

    @ParameterizedTest
    @EnumSource(SpeechCodec.Kind.class)
    void withoutLossTheSamplesAreThoseOfTheCodec(SpeechCodec.Kind kind) {
        SubstitutingDecoder decoder = new SubstitutingDecoder(kind);
        SpeechCodec plain = kind.open();

        for (byte[] frame : coded(kind, voice(10))) {
            assertArrayEquals(plain.decode(frame), decoder.decode(frame));
        }
    }

    @ParameterizedTest
    @EnumSource(SpeechCodec.Kind.class)
    void theFirstLostFrameIsTheLastGoodOneAgain(SpeechCodec.Kind kind) {
        SubstitutingDecoder decoder = new SubstitutingDecoder(kind);
        SpeechCodec plain = kind.open();
        byte[][] frames = coded(kind, voice(10));
        for (byte[] frame : frames) {
            decoder.decode(frame);
            plain.decode(frame);
        }

        assertArrayEquals(plain.decode(frames[9]), decoder.substitute());
    }

    @ParameterizedTest
    @EnumSource(SpeechCodec.Kind.class)
    void everyFurtherLostFrameIsThreeDecibelsWeakerAndAfter320MillisecondsThereIsSilence(SpeechCodec.Kind kind) {
        SubstitutingDecoder decoder = new SubstitutingDecoder(kind);
        double good = 0;
        for (byte[] frame : coded(kind, voice(10))) {
            good = rootMeanSquare(decoder.decode(frame));
        }

        for (int lost = 1; lost <= 16; lost++) {
            double level = decibels(decoder.substitute(), good);
            double expected = -3.01 * (lost - 1);
            if (kind != SpeechCodec.Kind.GSM_FULL_RATE) {
                // samples of some tens are rounded
                assertEquals(expected, level, lost < 12 ? 0.1 : 1, "lost frame " + lost);
            } else if (lost > 2) {
                // the decoder's filters ring on, and its weakest pulses are not nothing
                assertTrue(level < expected / 2, "lost frame " + lost + ": " + level + " dB");
            }
        }
        for (int lost = 17; lost <= 30; lost++) {
            assertArrayEquals(new short[FRAME], decoder.substitute());
        }
    }

    @ParameterizedTest
    @EnumSource(SpeechCodec.Kind.class)
    void beforeTheFirstGoodFrameThereIsSilence(SpeechCodec.Kind kind) {
        assertArrayEquals(new short[FRAME], new SubstitutingDecoder(kind).substitute());
    }

    @ParameterizedTest
    @EnumSource(SpeechCodec.Kind.class)
    void aGoodFrameEndsTheMuting(SpeechCodec.Kind kind) {
        SubstitutingDecoder decoder = new SubstitutingDecoder(kind);
        byte[][] frames = coded(kind, voice(20));
        double good = 0;
        for (int i = 0; i < 10; i++) {
            good = rootMeanSquare(decoder.decode(frames[i]));
        }
        for (int i = 0; i < 20; i++) {
            decoder.substitute();
        }

        double again = 0;
        for (int i = 10; i < 20; i++) {
            again = rootMeanSquare(decoder.decode(frames[i]));
        }
        assertEquals(1, again / good, 0.1);
        assertEquals(1, rootMeanSquare(decoder.substitute()) / good, 0.3);
    }

    private static final String KEYS = "**#**20**1234567890";

    /** What the receiver hears of {@link #KEYS} when this percentage of frames is lost. */
    private static String heard(SpeechCodec.Kind kind, double lostPercent, boolean substitute, long seed) {
        DtmfGenerator generator = new DtmfGenerator();
        KEYS.chars().forEach(key -> generator.enqueue(DtmfKey.of((char) key), 100, 100));
        short[] samples = new short[(KEYS.length() * 10 + 20) * FRAME];
        generator.read(samples);
        StringBuilder heard = new StringBuilder();
        DtmfReceiver receiver =
                new DtmfReceiver(digit -> heard.append(digit.key().symbol()));
        SubstitutingDecoder decoder = new SubstitutingDecoder(kind);
        Random random = new Random(seed);
        for (byte[] frame : coded(kind, samples)) {
            boolean lost = random.nextDouble() * 100 < lostPercent;
            receiver.accept(!lost ? decoder.decode(frame) : substitute ? decoder.substitute() : new short[FRAME]);
        }
        return heard.toString();
    }

    private static int rightOf(int calls, SpeechCodec.Kind kind, double lostPercent, boolean substitute) {
        int right = 0;
        for (int seed = 0; seed < calls; seed++) {
            right += heard(kind, lostPercent, substitute, seed).equals(KEYS) ? 1 : 0;
        }
        return right;
    }

    /** Of 200 calls with 20 % of the frames lost, 154 (A-law) and 96 (full rate) are heard right; with silence 64 and 46. */
    @ParameterizedTest
    @EnumSource(names = {"A_LAW", "GSM_FULL_RATE"})
    void keysSurviveMoreLossWithSubstitutionThanWithSilence(SpeechCodec.Kind kind) {
        int calls = 30;

        assertEquals(calls, rightOf(calls, kind, 0.5, true));
        int substituted = rightOf(calls, kind, 20, true);
        int silent = rightOf(calls, kind, 20, false);
        assertTrue(substituted > silent, substituted + " of " + calls + ", with silence " + silent);
    }
}
