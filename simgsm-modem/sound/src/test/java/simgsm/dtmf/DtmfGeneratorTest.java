package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.tone.ToneLevel;

class DtmfGeneratorTest {
    private static final ToneShape HARD = ToneShape.STANDARD.withRamp(0);

    private final List<DtmfKey> left = new ArrayList<>();
    private final DtmfGenerator generator = new DtmfGenerator(HARD, left::add);

    @Test
    void itIsSilentUntilAKeyComes() {
        short[] frame = {7, 7, 7};
        assertFalse(generator.read(frame));
        assertArrayEquals(new short[3], frame);
        assertTrue(generator.isIdle());
    }

    @Test
    void tonesAndPausesAreExactInSamples() {
        generator.enqueue(DtmfKey.FIVE, 40, 30);
        generator.enqueue(DtmfKey.A, 50, 10);
        short[] sound = new short[8 * 140];
        generator.read(sound);
        assertEquals(0, firstSound(sound, 0) / 2);
        assertTrue(silent(sound, 8 * 40, 8 * 70));
        assertEquals(8 * 70 + 1, firstSound(sound, 8 * 40));
        assertTrue(silent(sound, 8 * 120, 8 * 140));
        assertFalse(silent(sound, 8 * 119, 8 * 120));
        assertTrue(generator.isIdle());
    }

    @Test
    void theSoundDoesNotDependOnHowItIsTaken() {
        DtmfGenerator other = new DtmfGenerator(HARD, key -> {});
        for (DtmfKey key : DtmfKey.sequence("19*D")) {
            generator.enqueue(key, 73, 41);
            other.enqueue(key, 73, 41);
        }
        short[] whole = new short[8 * 114 * 4];
        generator.read(whole);
        short[] pieces = new short[whole.length];
        for (int from = 0, step = 1; from < pieces.length; from += step, step = step * 7 % 331) {
            other.read(pieces, from, Math.min(pieces.length, from + step));
        }
        assertArrayEquals(whole, pieces);
    }

    @Test
    void itTellsEachKeyWhoseToneHasLeft() {
        generator.enqueue(DtmfKey.ONE, 20, 20);
        generator.enqueue(DtmfKey.TWO, 20, 0);
        short[] frame = new short[159];
        generator.read(frame);
        assertEquals(List.of(), left);
        assertEquals(DtmfKey.ONE, generator.sounding());
        generator.read(new short[1]);
        assertEquals(List.of(DtmfKey.ONE), left);
        assertNull(generator.sounding());
        generator.read(new short[320]);
        assertEquals(List.of(DtmfKey.ONE, DtmfKey.TWO), left);
    }

    @Test
    void whatIsDroppedNeverLeaves() {
        generator.enqueue(DtmfKey.ONE);
        generator.enqueue(DtmfKey.TWO);
        generator.enqueue(DtmfKey.THREE);
        generator.read(new short[8 * 150]);
        assertEquals(2, generator.drop());
        short[] frame = new short[1600];
        assertFalse(generator.read(frame));
        assertEquals(List.of(DtmfKey.ONE), left);
        assertEquals(0, generator.drop());
    }

    @Test
    void aToneCutShortCountsAsDropped() {
        generator.enqueue(DtmfKey.ONE);
        generator.read(new short[100]);
        assertEquals(1, generator.drop());
        assertTrue(generator.isIdle());
        assertEquals(List.of(), left);
    }

    @Test
    void aListenerMayDropFromWithin() {
        DtmfGenerator[] self = new DtmfGenerator[1];
        self[0] = new DtmfGenerator(HARD, key -> self[0].drop());
        self[0].enqueue(DtmfKey.ONE, 20, 20);
        self[0].enqueue(DtmfKey.TWO, 20, 20);
        short[] frame = new short[640];
        self[0].read(frame);
        assertTrue(silent(frame, 160, 640));
    }

    @Test
    void aKeySoundsAsLongAsItIsDown() {
        generator.press(DtmfKey.HASH);
        for (int i = 0; i < 50; i++) {
            assertTrue(generator.read(new short[160]));
        }
        generator.release();
        short[] after = new short[160];
        generator.read(after);
        assertTrue(silent(after, 0, 160));
        assertEquals(List.of(DtmfKey.HASH), left);
    }

    @Test
    void aKeyLetGoAtOnceStillSounds70Milliseconds() {
        generator.press(DtmfKey.SEVEN);
        generator.release();
        generator.press(DtmfKey.SEVEN);
        generator.release();
        short[] sound = new short[8 * 300];
        generator.read(sound);
        assertFalse(silent(sound, 8 * 69, 8 * 70));
        assertTrue(silent(sound, 8 * 70, 8 * 135));
        assertEquals(8 * 135 + 1, firstSound(sound, 8 * 70));
        assertEquals(List.of(DtmfKey.SEVEN, DtmfKey.SEVEN), left);
    }

    @Test
    void aSecondKeyLetsTheFirstGo() {
        generator.press(DtmfKey.ONE);
        generator.read(new short[8 * 100]);
        generator.press(DtmfKey.TWO);
        generator.read(new short[8 * 200]);
        assertEquals(List.of(DtmfKey.ONE), left);
        assertEquals(DtmfKey.TWO, generator.sounding());
    }

    @ParameterizedTest
    @EnumSource
    void aToneIsAsPureAsSixteenBitsAllow(DtmfKey key) {
        generator.enqueue(key, 1000, 0);
        short[] sound = new short[8000];
        generator.read(sound);
        // A whole second holds whole periods of both, so the two sines are exactly two bins of its Fourier sum.
        double tones = 2.0 / 8000 * (energy(sound, key.rowHertz()) + energy(sound, key.columnHertz()));
        double total = 0;
        for (short sample : sound) {
            total += (double) sample * sample;
        }
        double sinad = 10 * Math.log10(tones / (total - tones));
        assertTrue(sinad >= 87, "SINAD " + sinad);
    }

    @ParameterizedTest
    @EnumSource
    void frequencyAndLevelAreExact(DtmfKey key) {
        generator.enqueue(key, 10_000, 0);
        short[] sound = new short[80_000];
        generator.read(sound);
        for (double hertz : new double[] {key.rowHertz(), key.columnHertz()}) {
            double first = phase(sound, 0, hertz);
            double last = phase(sound, 72_000, hertz);
            double drift = Math.IEEEremainder(last - first, 2 * Math.PI);
            double ppm = 1e6 * drift / (2 * Math.PI * hertz * 9);
            assertEquals(0, ppm, 0.1);
            double amplitude = 2 * Math.sqrt(energy(java.util.Arrays.copyOf(sound, 8000), hertz)) / 8000;
            assertEquals(-10, ToneLevel.dbm0(amplitude), 0.001);
        }
    }

    @Test
    void zeroDbm0Is3Point14BelowFullScale() {
        assertEquals(32768, ToneLevel.amplitude(3.14), 1e-6);
        assertEquals(22827, ToneLevel.amplitude(0), 1);
        assertEquals(-10, ToneLevel.dbm0(ToneLevel.amplitude(-10)), 1e-12);
    }

    @Test
    void twoTonesTooLoudTogetherAreClippedNotWrapped() {
        DtmfGenerator loud = new DtmfGenerator(ToneShape.STANDARD.withLevel(3), key -> {});
        loud.enqueue(DtmfKey.FIVE);
        short[] sound = new short[800];
        loud.read(sound);
        int jump = 0;
        int peak = 0;
        for (int i = 1; i < sound.length; i++) {
            jump = Math.max(jump, Math.abs(sound[i] - sound[i - 1]));
            peak = Math.max(peak, sound[i]);
        }
        assertEquals(32767, peak);
        assertTrue(jump < 60_000, "jump of " + jump);
    }

    @Test
    void lengthsCountAtHalfAmplitudeWhateverTheRamp() {
        for (double ramp : new double[] {0, 2, 5, 10}) {
            DtmfGenerator soft = new DtmfGenerator(new ToneShape(50, 50, -10, -10, ramp), key -> {});
            soft.enqueue(DtmfKey.FIVE);
            soft.enqueue(DtmfKey.FIVE);
            short[] sound = new short[1600];
            soft.read(sound);
            int half = (int) (8 * ramp / 2);
            for (int start : new int[] {0, 800}) {
                assertEquals(0.5, envelope(sound, start + half), ramp == 0 ? 0.6 : 0.15, "rise of " + ramp + " ms");
                assertEquals(
                        0.5, envelope(sound, start + 400 + half), ramp == 0 ? 0.6 : 0.15, "fall of " + ramp + " ms");
                assertEquals(1, envelope(sound, start + 200), 0.02);
            }
            assertTrue(silent(sound, (int) (400 + 8 * ramp), 800));
        }
    }

    /** Of one key's two tones, measured over 2 ms against what they would be at full level there. */
    private static double envelope(short[] sound, int at) {
        DtmfGenerator hard = new DtmfGenerator(HARD, key -> {});
        hard.enqueue(DtmfKey.FIVE, 100, 0);
        short[] full = new short[800];
        hard.read(full);
        double product = 0;
        double square = 0;
        for (int i = Math.max(0, at - 8); i < at + 8; i++) {
            product += (double) sound[i] * full[i % 800];
            square += (double) full[i % 800] * full[i % 800];
        }
        return product / square;
    }

    @Test
    void aFallIsNoLongerThanThePause() {
        DtmfGenerator soft = new DtmfGenerator(new ToneShape(50, 1, -10, -10, 5), key -> {});
        soft.enqueue(DtmfKey.FIVE);
        short[] sound = new short[800];
        soft.read(sound);
        assertTrue(silent(sound, 408, 800));
        assertTrue(soft.isIdle());
    }

    @Test
    void withRampsLessSoundLiesOutsideTheTones() {
        double hard = beside(0);
        assertTrue(beside(2) < hard / 30, "2 ms against none: " + beside(2) / hard);
        assertTrue(beside(5) < beside(2) / 10);
    }

    /** Energy at frequencies 500 Hz and more away from both tones of a key of 50 ms. */
    private static double beside(double rampMillis) {
        DtmfGenerator generator = new DtmfGenerator(new ToneShape(50, 50, -10, -10, rampMillis), key -> {});
        generator.enqueue(DtmfKey.ONE);
        short[] sound = new short[800];
        generator.read(sound);
        double sum = 0;
        for (double hertz = 1800; hertz < 3900; hertz += 10) {
            sum += energy(sound, hertz);
        }
        return sum;
    }

    @Test
    void nonsenseShapesAreRefusedAtBirth() {
        assertThrows(IllegalArgumentException.class, () -> ToneShape.STANDARD.withMillis(0, 100));
        assertThrows(IllegalArgumentException.class, () -> ToneShape.STANDARD.withMillis(100, -1));
        assertThrows(IllegalArgumentException.class, () -> ToneShape.STANDARD.withLevel(4));
        assertThrows(IllegalArgumentException.class, () -> ToneShape.STANDARD.withLevel(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> new ToneShape(10, 10, -10, -10, 11));
    }

    private static double energy(short[] sound, double hertz) {
        Goertzel goertzel = new Goertzel(hertz);
        goertzel.accept(sound, 0, sound.length);
        return goertzel.energy();
    }

    /** Over one second. */
    private static double phase(short[] sound, int from, double hertz) {
        double real = 0;
        double imaginary = 0;
        for (int i = from; i < from + 8000; i++) {
            real += sound[i] * Math.cos(2 * Math.PI * hertz * i / 8000);
            imaginary -= sound[i] * Math.sin(2 * Math.PI * hertz * i / 8000);
        }
        return Math.atan2(imaginary, real);
    }

    private static int peak(short[] sound, int from, int to) {
        int peak = 0;
        for (int i = from; i < to; i++) {
            peak = Math.max(peak, Math.abs(sound[i]));
        }
        return peak;
    }

    private static boolean silent(short[] sound, int from, int to) {
        return peak(sound, from, to) == 0;
    }

    private static int firstSound(short[] sound, int from) {
        int at = from;
        while (sound[at] == 0) {
            at++;
        }
        return at;
    }
}
