package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneTracer;
import simgsm.ui.Theme.Ink;

/** The tone scope, painted without a display. */
class ToneScopeTest {
    @BeforeEach
    void light() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    private static ToneScope scopeAfter(DtmfKey key, int millis) {
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(key);
        ToneTracer tracer = new ToneTracer();
        for (int i = 0; i < millis / 20; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        ToneScope scope = new ToneScope(Locale.ENGLISH);
        scope.show(tracer.newest());
        return scope;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.25, 2})
    void aToneShowsTwoBarsAWaveAndItsKey(double scale) {
        int quiet = Painted.count(Painted.at(new ToneScope(Locale.ENGLISH), scale), Ink.ACCENT);
        int sounding = Painted.count(Painted.at(scopeAfter(DtmfKey.HASH, 80), scale), Ink.ACCENT);
        assertTrue(sounding > quiet + 800 * scale * scale, quiet + " and " + sounding);
    }

    @Test
    void theNumbersAreSpoken() {
        String spoken = scopeAfter(DtmfKey.FIVE, 160).getAccessibleContext().getAccessibleName();
        assertTrue(spoken.startsWith("Tone scope: key 5, -"), spoken);
    }

    @Test
    void beforeAnyToneTheScopeSaysItsNameOnly() {
        assertEquals(
                "Tone scope",
                new ToneScope(Locale.ENGLISH).getAccessibleContext().getAccessibleName());
    }

    @Test
    void eachKeyLooksDifferent() {
        var pictures = new java.util.HashSet<Integer>();
        for (DtmfKey key : DtmfKey.values()) {
            pictures.add(Painted.hash(Painted.at(scopeAfter(key, 80), 1)));
        }
        assertEquals(DtmfKey.values().length, pictures.size());
    }
}
