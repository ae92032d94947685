package simgsm.modem;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Keys at 200 ms, as a phone here sends them, and losses of speech between them. */
class OutageWatchTest {
    private static final int MILLI = 8;

    private final OutageWatch watch = new OutageWatch();

    private boolean keyAfter(int millis) {
        watch.heard(millis * MILLI);
        return watch.keyDecided();
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

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aKeySurvivesTheLossOfOneOrTwoFrames(int frames) {
        assertFalse(keyAfter(200));
        watch.lost(frames);
        assertFalse(keyAfter(400));
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
