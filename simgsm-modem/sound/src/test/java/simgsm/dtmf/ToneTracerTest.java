package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the tone scope measures. */
class ToneTracerTest {
    private final ToneTracer tracer = new ToneTracer();
    private final DtmfGenerator generator = new DtmfGenerator();

    private void pass(int frames) {
        for (int i = 0; i < frames; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
    }

    @ParameterizedTest
    @EnumSource(DtmfKey.class)
    void theTwoFrequenciesOfAKeyStandAtTheirLevelAndTheOthersFarBelow(DtmfKey key) {
        generator.enqueue(key);
        pass(4);
        for (int i = 0; i < 4; i++) {
            double row = tracer.newest().rowDbm0(i);
            double column = tracer.newest().columnDbm0(i);
            assertEquals(i == key.row(), row > -12, "row " + i + " at " + row);
            assertEquals(i == key.column(), column > -12, "column " + i + " at " + column);
        }
        assertEquals(-10, tracer.newest().rowDbm0(key.row()), 0.7);
        assertEquals(-10, tracer.newest().columnDbm0(key.column()), 0.7);
    }

    @Test
    void theKeySoundsAndThenHasSounded() {
        generator.enqueue(DtmfKey.SEVEN);
        pass(4);
        assertTrue(tracer.newest().isSounding());
        pass(6);
        assertFalse(tracer.newest().isSounding());
        assertEquals(DtmfKey.SEVEN, tracer.newest().digit().orElseThrow().key());
        assertEquals(100, tracer.newest().digit().orElseThrow().durationMillis(), 10);
    }

    /** Ten keys, as the scope hears them under an experiment. */
    private ToneScore score(double snrDecibels, double shiftPercent) {
        tracer.tryOut(new ToneExperiment(snrDecibels, shiftPercent));
        DtmfKey.sequence("1234567890").forEach(generator::enqueue);
        pass(110);
        return tracer.newest().score();
    }

    @Test
    void aLittleNoiseIsNoHindrance() {
        assertEquals(new ToneScore(10, 0, 0), score(15, 0));
    }

    @Test
    void inMuchNoiseKeysAreMissed() {
        ToneScore score = score(-15, 0);
        assertEquals(10, score.keys());
        assertTrue(score.missed() >= 8, score.toString());
    }

    @Test
    void noiseIsMeasuredAgainstTheTones() {
        tracer.tryOut(new ToneExperiment(0, 0));
        short[] silence = new short[160];
        generator.enqueue(DtmfKey.ONE);
        pass(5);
        for (int i = 0; i < 3; i++) {
            tracer.accept(silence);
        }
        double sum = 0;
        for (int i = 0; i < ToneTrace.SAMPLES; i++) {
            sum += Math.pow(tracer.newest().sample(i), 2);
        }
        double decibels = 10 * Math.log10(sum / ToneTrace.SAMPLES / Math.pow(ToneLevel.amplitude(-10), 2));
        assertEquals(0, decibels, 1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1.5, -0.5, 0.5, 1.5})
    void aSmallShiftIsHeardAndMeasured(double percent) {
        assertEquals(new ToneScore(10, 0, 0), score(Double.POSITIVE_INFINITY, percent));
        assertEquals(percent, tracer.newest().digit().orElseThrow().frequencyErrorPercent(), 0.15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-4, 4})
    void aLargeShiftIsNoKey(double percent) {
        assertEquals(new ToneScore(0, 10, 0), score(Double.POSITIVE_INFINITY, percent));
    }

    @Test
    void anExperimentLeavesTheSoundAsItIs() {
        tracer.tryOut(new ToneExperiment(0, 3));
        generator.enqueue(DtmfKey.FIVE);
        short[] frame = new short[160];
        generator.read(frame);
        short[] before = frame.clone();
        tracer.accept(frame);
        assertArrayEquals(before, frame);
    }

    @Test
    void everyNewExperimentBeginsItsScoreAnew() {
        score(15, 0);
        tracer.tryOut(new ToneExperiment(14, 0));
        assertEquals(ToneScore.NONE, tracer.newest().score());
        assertEquals(14, tracer.newest().experiment().snrDecibels());
    }

    /** The dashed lines mean what they say: just above them a key is heard, below the lowest it is not. */
    @Test
    void theThresholdsAreTheReceivers() {
        double level = ToneTrace.LEAST_DBM0 + 3;
        generator.enqueue(DtmfKey.FIVE, ToneShape.STANDARD.withLevel(level));
        pass(10);
        assertEquals(DtmfKey.FIVE, tracer.newest().digit().orElseThrow().key());
        generator.enqueue(DtmfKey.NINE, ToneShape.STANDARD.withLevel(ToneTrace.LEAST_DBM0 - 1));
        generator.enqueue(DtmfKey.NINE, new ToneShape(100, 100, -10, -10 - ToneTrace.MOST_TWIST_DECIBELS - 1, 0));
        pass(20);
        assertEquals(DtmfKey.FIVE, tracer.newest().digit().orElseThrow().key());
        generator.enqueue(DtmfKey.ZERO, new ToneShape(100, 100, -10, -16, 0));
        pass(4);
        assertEquals(-16 - ToneTrace.MOST_TWIST_DECIBELS, tracer.newest().leastRowDbm0(), 1);
        assertEquals(-10 - ToneTrace.MOST_TWIST_DECIBELS, tracer.newest().leastColumnDbm0(), 1);
    }

    @Test
    void whenNoSoundComesThePictureRestsAndTheLastKeyStays() {
        tracer.tryOut(new ToneExperiment(10, 0));
        generator.enqueue(DtmfKey.FIVE);
        pass(4);
        tracer.rest();
        ToneTrace trace = tracer.newest();
        assertFalse(trace.isSounding());
        assertEquals(ToneTrace.FLOOR_DBM0, trace.rowDbm0(1));
        assertEquals(DtmfKey.FIVE, trace.digit().orElseThrow().key());
    }

    @Test
    void silenceAfterSilenceChangesNothing() {
        ToneTrace before = tracer.newest();
        assertFalse(tracer.accept(new short[160]));
        assertSame(before, tracer.newest());
    }

    @Test
    void thePictureGoesQuietAfterATone() {
        generator.enqueue(DtmfKey.ONE);
        pass(20);
        assertEquals(0, tracer.newest().sample(ToneTrace.SAMPLES - 1));
        assertEquals(ToneTrace.FLOOR_DBM0, tracer.newest().rowDbm0(0));
    }

    @Test
    void aResetForgetsAll() {
        generator.enqueue(DtmfKey.ONE);
        pass(4);
        tracer.reset();
        assertSame(ToneTrace.EMPTY, tracer.newest());
    }
}
