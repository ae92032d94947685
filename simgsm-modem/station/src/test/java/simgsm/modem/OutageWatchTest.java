package simgsm.modem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.SpeechCodec;
import simgsm.speech.SubstitutingDecoder;

/** Keys at 200 ms, as a phone here sends them, and losses of speech between them. */
class OutageWatchTest {
    private static final int MILLI = 8;

    private final OutageWatch watch = new OutageWatch();

    private int keys;
    private long now;

    /** A key other than the last one. */
    private boolean keyAfter(int millis) {
        keys++;
        return keyAfter(millis, DtmfKey.values()[keys % 2]);
    }

    private boolean keyAfter(int millis, DtmfKey key) {
        watch.heard(millis * MILLI);
        now += millis;
        return watch.keyDecided(DtmfDigit.reported(key, now * MILLI, OptionalInt.empty()));
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 5})
    void theSameKeyAfterAnOutageOfFiveFramesMayBeTheOneBefore(int frames) {
        DtmfKey key = DtmfKey.values()[0];
        assertFalse(keyAfter(200, key));
        watch.lost(frames);
        assertEquals(frames == 5, keyAfter(160, key));
        // The outage may have held both; after a shorter one this is too soon for a tone and a pause.
        assertTrue(keyAfter(80, key));
        assertFalse(keyAfter(200, key));
    }

    @Test
    void anOutageLongBeforeAnOrderDoesNotBreakIt() {
        DtmfKey star = DtmfKey.of('*');
        watch.lost(10);
        assertFalse(keyAfter(2_000, star));
        assertFalse(keyAfter(200, star));
    }

    /** A tone, its pause and the next tone, of which any ten frames or fewer are lost. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 6, 10})
    void whereverFramesAreLostNoKeyIsDoubledUnseen(int frames) {
        for (int from = 1; from < 30; from++) {
            for (int shift = 0; shift < SpeechCodec.SAMPLES_PER_FRAME; shift += 80) {
                List<DtmfKey> heard = heard("0#9", from, frames, shift);
                for (int i = 1; i < heard.size(); i++) {
                    assertTrue(heard.get(i) == null || heard.get(i) != heard.get(i - 1), () -> frames + ": " + heard);
                }
            }
        }
    }

    /** The keys through GSM full rate, as M2 hears them; null where the watch doubts. */
    private static List<DtmfKey> heard(String keys, int from, int frames, int shift) {
        DtmfGenerator tones = new DtmfGenerator();
        for (char key : keys.toCharArray()) {
            tones.enqueue(DtmfKey.of(key), 100, 100);
        }
        tones.read(new short[SpeechCodec.SAMPLES_PER_FRAME], 0, shift);
        List<DtmfKey> heard = new ArrayList<>();
        OutageWatch outages = new OutageWatch();
        DtmfReceiver receiver = new DtmfReceiver(digit -> {
            if (outages.keyDecided(digit)) {
                heard.add(null);
            }
            heard.add(digit.key());
        });
        SpeechCodec coder = SpeechCodec.Kind.GSM_FULL_RATE.open();
        SubstitutingDecoder decoder = new SubstitutingDecoder(SpeechCodec.Kind.GSM_FULL_RATE);
        for (int i = 0; i < 10 * keys.length() + 16; i++) {
            short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
            tones.read(frame);
            byte[] coded = coder.encode(frame);
            // The loss is known when the next frame arrives, before its substitutes are heard.
            if (i == from) {
                outages.lost(frames);
            }
            short[] samples = i >= from && i < from + frames ? decoder.substitute() : decoder.decode(coded);
            outages.heard(samples.length);
            receiver.setLimit(outages.isNear() ? Modem.OUTAGE_LIMIT : DtmfReceiver.LIMIT);
            receiver.accept(samples);
        }
        return heard;
    }

    @Test
    void withoutLossNoPauseIsSuspected() {
        assertFalse(keyAfter(200));
        assertFalse(keyAfter(200));
        assertFalse(keyAfter(5_000));
    }

    @Test
    void anOutageBetweenKeysOfTheUsualIntervalHasHiddenNone() {
        assertFalse(keyAfter(200));
        watch.lost(6);
        assertFalse(keyAfter(200));
    }

    @Test
    void anOutageInAnIntervalOfTwoKeysMayHaveHiddenOne() {
        assertFalse(keyAfter(200));
        assertFalse(keyAfter(200));
        watch.lost(3);
        assertTrue(keyAfter(400));
        assertFalse(keyAfter(400));
    }

    @Test
    void ofQuickKeysTheShortestIntervalSaysWhatIsLong() {
        assertFalse(keyAfter(130));
        assertFalse(keyAfter(130));
        watch.lost(4);
        assertTrue(keyAfter(260));
    }

    @Test
    void aKeyThatIsDecidedLateAfterAnOutageIsNotSuspectedNorTakenAsMeasure() {
        assertFalse(keyAfter(200));
        assertFalse(keyAfter(200));
        watch.lost(4);
        assertFalse(keyAfter(280));
        assertFalse(keyAfter(120));
        watch.lost(4);
        assertFalse(keyAfter(280));
    }

    @Test
    void anOutageOfTwoFramesInTwiceTheRegularIntervalMayHaveHiddenAKeyOfTheseButNoneOfAPersonsPause() {
        assertFalse(keyAfter(200));
        assertFalse(keyAfter(200));
        watch.lost(2);
        assertTrue(keyAfter(400));
        assertFalse(keyAfter(200));
        watch.lost(2);
        assertFalse(keyAfter(500));
    }

    @Test
    void aKeySurvivesTheLossOfOneFrame() {
        assertFalse(keyAfter(200));
        assertFalse(keyAfter(200));
        watch.lost(1);
        assertFalse(keyAfter(400));
    }

    @Test
    void anIntervalWithALossOfAnyLengthIsNoMeasureOfThePace() {
        assertFalse(keyAfter(200));
        watch.lost(1);
        assertFalse(keyAfter(250));
        assertFalse(keyAfter(110));
        assertFalse(keyAfter(200));
        watch.lost(3);
        assertFalse(keyAfter(260));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void theSameKeySoonerThanAToneAndAPauseAfterAnOutageMayBeTheRestOfTheOneBefore(int frames) {
        DtmfKey nine = DtmfKey.of('9');
        assertFalse(keyAfter(200, DtmfKey.of('#')));
        watch.lost(frames);
        assertFalse(keyAfter(200, nine));
        assertTrue(keyAfter(120, nine));
        assertFalse(keyAfter(400, DtmfKey.of('#')));
        assertFalse(keyAfter(400, nine));
        watch.lost(frames);
        assertTrue(keyAfter(125, nine));
    }

    @Test
    void tonesAreDisturbedUpTo200MillisecondsAfterAnOutageOfTwoFrames() {
        watch.lost(1);
        assertFalse(watch.isNear());
        watch.lost(2);
        watch.heard(239 * MILLI);
        assertTrue(watch.isNear());
        watch.heard(MILLI);
        assertFalse(watch.isNear());
    }

    /** Each run of two or three frames lost while a phone here sends an order. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void anOrderWithAKeyLostInsideIsNeverHeardAsAnother(int frames) {
        String order = "**#*#90**";
        int whole = 0;
        for (int from = 1; from < 10 * order.length(); from++) {
            String heard = text(heard(order, from, frames, 0));
            boolean isEndLost = order.startsWith(heard) || order.endsWith(heard);
            String told = from + ": " + heard;
            assertTrue(heard.equals(order) || heard.contains("?") || isEndLost, told);
            whole += heard.equals(order) ? 1 : 0;
        }
        assertTrue(whole >= 0.95 * (10 * order.length() - 1), whole + " heard as keyed");
    }

    private static String text(List<DtmfKey> keys) {
        StringBuilder text = new StringBuilder();
        keys.forEach(key -> text.append(key == null ? '?' : key.symbol()));
        return text.toString();
    }

    @Test
    void beforeTheFirstKeyOfACallNothingIsSuspected() {
        assertFalse(keyAfter(200));
        watch.lost(10);
        watch.reset();
        watch.lost(10);
        assertFalse(keyAfter(4_000));
    }
}
