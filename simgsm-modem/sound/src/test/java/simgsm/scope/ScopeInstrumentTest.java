package simgsm.scope;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneLevels;
import simgsm.scope.KeyPrediction.Stage;
import simgsm.scope.ScopeInstrument.Picture;
import simgsm.tone.ToneExperiment;

class ScopeInstrumentTest {
    private final ScopeInstrument instrument = new ScopeInstrument();
    private final DtmfGenerator generator = new DtmfGenerator();
    private final ToneTracer tracer = new ToneTracer();

    @Test
    void aFrozenScopeKeepsItsTraceAndGoesOnWithTheNewest() {
        ToneTrace first = heard(DtmfKey.ONE);
        instrument.show(first);
        instrument.freeze(true);

        assertFalse(instrument.show(heard(DtmfKey.TWO)));
        assertSame(first, instrument.trace());
        instrument.freeze(false);
        assertEquals(
                DtmfKey.TWO, instrument.trace().modem().digit().orElseThrow().key());
    }

    @Test
    void eachPictureHasItsOwnCursors() {
        instrument.cursors().put(0, 4, 0);
        instrument.cursors().put(1, 12, 0);
        assertEquals(125, instrument.cursors().periodHertz());
        assertFalse(instrument.cursors().hasFrequencies());

        instrument.choose(Picture.SPECTROGRAM);
        instrument.cursors().put(0, 100, 770);
        instrument.cursors().put(1, 300, 1336);
        assertEquals(566, instrument.cursors().differenceHertz());
        assertEquals(200, instrument.cursors().differenceMillis());

        instrument.choose(Picture.LEVELS);
        assertEquals(8, instrument.cursors().differenceMillis());
    }

    @Test
    void cursorsStayOnThePicture() {
        instrument.choose(Picture.SPECTROGRAM);
        instrument.cursors().move(0, -5000, 9000);

        assertEquals(0, instrument.cursors().place(0).millis());
        assertEquals(ScopeInstrument.MOST_HERTZ, instrument.cursors().place(0).hertz());
        assertEquals(0, instrument.cursors().nearest(10, 1700));
        assertEquals(1, instrument.cursors().nearest(1300, 1300));
    }

    @Test
    void aKeyIsHiddenUntilItIsGuessed() {
        instrument.prediction().set(true);
        assertEquals(Stage.WAITING, instrument.prediction().stage());
        assertTrue(instrument.prediction().isHiding());

        instrument.show(heard(DtmfKey.FIVE));
        assertEquals(Stage.ASKING, instrument.prediction().stage());
        instrument.prediction().guess(DtmfKey.SIX);

        assertEquals(Stage.WRONG, instrument.prediction().stage());
        assertEquals(Optional.of(DtmfKey.FIVE), instrument.prediction().answer());
        assertFalse(instrument.prediction().isHiding());
    }

    @Test
    void thePictureOfAKeyIsHeldAndLaterKeysAreNotAskedFor() {
        instrument.prediction().set(true);
        instrument.show(heard(DtmfKey.FIVE));
        ToneTrace asked = instrument.trace();
        instrument.show(heard(DtmfKey.NINE));

        assertSame(asked, instrument.trace());
        instrument.prediction().guess(DtmfKey.FIVE);
        assertEquals(Stage.RIGHT, instrument.prediction().stage());
        instrument.show(tracer.newest());
        assertEquals(Stage.RIGHT, instrument.prediction().stage());
        instrument.show(heard(DtmfKey.FIVE));
        assertEquals(Stage.ASKING, instrument.prediction().stage());
        assertEquals(1, instrument.prediction().right());
        assertEquals(1, instrument.prediction().asked());
    }

    /** From the first frame to 200 ms after the end, as a call brings them. */
    @ParameterizedTest
    @EnumSource
    void theHeldPictureShowsTheTonesOfTheKeyAndNotTheirEnd(DtmfKey key) {
        instrument.prediction().set(true);
        generator.enqueue(key, 150, 200);
        for (int i = 0; i < 18; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
            instrument.show(tracer.newest());
        }

        ToneLevels levels = instrument.trace().modem().levels();
        for (int tone = 0; tone < 8; tone++) {
            boolean isOfKey = tone == key.row() || tone == 4 + key.column();
            assertEquals(isOfKey, levels.dbm0(tone) > -20, tone + ": " + levels.dbm0(tone));
        }
    }

    @Test
    void aFrozenScopeAsksForNoKeyThatItDoesNotShow() {
        instrument.prediction().set(true);
        instrument.freeze(true);
        instrument.show(heard(DtmfKey.FIVE));
        assertEquals(Stage.WAITING, instrument.prediction().stage());

        instrument.freeze(false);
        instrument.show(tracer.newest());
        assertEquals(Stage.ASKING, instrument.prediction().stage());
        assertEquals(
                DtmfKey.FIVE, instrument.trace().modem().digit().orElseThrow().key());
    }

    @Test
    void theKeyThatWasHeardBeforeIsNotAskedFor() {
        instrument.show(heard(DtmfKey.FIVE));
        instrument.prediction().set(true);
        instrument.show(tracer.newest());

        assertEquals(Stage.WAITING, instrument.prediction().stage());
        instrument.prediction().guess(DtmfKey.FIVE);
        assertEquals(0, instrument.prediction().asked());
    }

    @Test
    void aPracticeToneIsThatOfItsKeyAndIsAskedForEvenIfNoReceiverHearsIt() {
        PracticeTone practice = new PracticeTone(1);
        PracticeTone.Played clear = practice.next(ToneExperiment.NONE);
        assertEquals(clear.key(), clear.trace().modem().digit().orElseThrow().key());
        PracticeTone.Played drowned = practice.next(new ToneExperiment(-20, 0));
        instrument.prediction().set(true);
        instrument.prediction().ask(drowned.trace(), drowned.key());

        assertSame(drowned.trace(), instrument.trace());
        instrument.prediction().guess(drowned.key());
        assertEquals(Stage.RIGHT, instrument.prediction().stage());
    }

    @Test
    void practiceTonesOfOneSeedAreTheSame() {
        PracticeTone one = new PracticeTone(7);
        PracticeTone same = new PracticeTone(7);
        PracticeTone other = new PracticeTone(8);
        StringBuilder keys = new StringBuilder();
        StringBuilder others = new StringBuilder();
        for (int i = 0; i < 10; i++) {
            PracticeTone.Played played = one.next(ToneExperiment.NONE);
            assertEquals(played.key(), same.next(ToneExperiment.NONE).key());
            keys.append(played.key().symbol());
            others.append(other.next(ToneExperiment.NONE).key().symbol());
        }
        assertNotEquals(keys.toString(), others.toString());
    }

    /** The trace while this key sounds, after those before it. */
    private ToneTrace heard(DtmfKey key) {
        generator.enqueue(key);
        ToneTrace sounding = tracer.newest();
        while (!generator.isIdle()) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
            sounding = tracer.newest().modem().isSounding() ? tracer.newest() : sounding;
        }
        return sounding;
    }
}
