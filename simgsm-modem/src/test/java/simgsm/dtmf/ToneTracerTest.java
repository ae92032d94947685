package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

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
