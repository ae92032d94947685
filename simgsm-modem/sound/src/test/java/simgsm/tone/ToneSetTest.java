package simgsm.tone;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.Goertzel;

/** Call-progress tones: frequencies, cadences and levels as the standards' tables have them. */
class ToneSetTest {
    private static short[] sound(ToneSet set, ProgressTone tone, int millis) {
        CadencePlayer player = new CadencePlayer();
        player.start(set.cadence(tone));
        short[] samples = new short[millis * 8];
        player.addTo(samples);
        return samples;
    }

    private static double dbm0(short[] samples, double hertz, int fromMillis, int toMillis) {
        Goertzel filter = new Goertzel(hertz);
        filter.accept(samples, fromMillis * 8, toMillis * 8);
        return ToneLevel.dbm0(Math.max(1, filter.amplitude()));
    }

    private static boolean isSilent(short[] samples, int fromMillis, int toMillis) {
        for (int i = fromMillis * 8; i < toMillis * 8; i++) {
            if (samples[i] != 0) {
                return false;
            }
        }
        return true;
    }

    @ParameterizedTest
    @CsvSource({
        "EUROPEAN, RING_BACK, 1000, 4000, 425, 425, -13",
        "EUROPEAN, BUSY, 500, 500, 425, 425, -13",
        "EUROPEAN, CONGESTION, 200, 200, 425, 425, -13",
        "EUROPEAN, CALL_DROPPED, 200, 200, 425, 425, -13",
        "AMERICAN, RING_BACK, 2000, 4000, 440, 480, -19",
        "AMERICAN, BUSY, 500, 500, 480, 620, -24",
        "AMERICAN, CONGESTION, 250, 250, 480, 620, -24",
        "AMERICAN, CALL_WAITING, 300, 9700, 440, 440, -13",
    })
    void aToneHasItsFrequenciesItsLevelAndItsCadence(
            ToneSet set, ProgressTone tone, int on, int off, double one, double other, double level) {
        short[] samples = sound(set, tone, 2 * (on + off));
        for (int start : List.of(0, on + off)) {
            // Whole tenths of a second hold whole periods of all these frequencies: no leakage from one to the other.
            int from = start + (on - on / 100 * 100) / 2 + (on > 200 ? 50 : 0);
            int to = from + (on > 200 ? (on - 100) / 100 * 100 : on);
            double atLeast = on > 200 ? 0.1 : 0.5;
            assertEquals(level, dbm0(samples, one, from, to), atLeast);
            assertEquals(level, dbm0(samples, other, from, to), atLeast);
            assertTrue(isSilent(samples, start + on, start + on + off), "pause");
            assertTrue(!isSilent(samples, start, start + 2), "begins at once");
            assertTrue(!isSilent(samples, start + on - 2, start + on), "sounds to its end");
        }
    }

    @ParameterizedTest
    @CsvSource({"EUROPEAN, 330, 330, 330, 950, 1400, 1800, -13", "AMERICAN, 380, 274, 380, 985.2, 1370.6, 1776.7, -24"})
    void specialInformationClimbsInThreeSteps(
            ToneSet set, int one, int two, int three, double low, double middle, double high, double level) {
        short[] samples = sound(set, ProgressTone.SPECIAL_INFORMATION, one + two + three + 1000 + one);
        assertEquals(level, dbm0(samples, low, 10, one - 10), 0.3);
        assertEquals(level, dbm0(samples, middle, one + 10, one + two - 10), 0.3);
        assertEquals(level, dbm0(samples, high, one + two + 10, one + two + three - 10), 0.3);
        int end = one + two + three;
        assertTrue(isSilent(samples, end, end + 1000));
        assertEquals(level, dbm0(samples, low, end + 1010, end + 1000 + one - 10), 0.3);
    }

    @Test
    void europeanCallWaitingIsTwoShortBursts() {
        short[] samples = sound(ToneSet.EUROPEAN, ProgressTone.CALL_WAITING, 4200);
        for (int start : List.of(0, 800, 4000)) {
            assertEquals(-13, dbm0(samples, 425, start + 20, start + 180), 0.3);
        }
        assertTrue(isSilent(samples, 200, 800));
        assertTrue(isSilent(samples, 1000, 4000));
    }

    @ParameterizedTest
    @CsvSource({"EUROPEAN, 425, 425, -13", "AMERICAN, 350, 440, -13"})
    void dialToneNeverPauses(ToneSet set, double one, double other, double level) {
        short[] samples = sound(set, ProgressTone.DIAL, 10_000);
        for (int from = 100; from < 9_000; from += 700) {
            assertEquals(level, dbm0(samples, one, from, from + 200), 0.1);
            assertEquals(level, dbm0(samples, other, from, from + 200), 0.1);
        }
    }

    @ParameterizedTest
    @EnumSource(ToneSet.class)
    void everySetHasEveryToneAndNoneIsAKey(ToneSet set) {
        for (ProgressTone tone : ProgressTone.values()) {
            assertNotNull(set.cadence(tone), tone.name());
            DtmfReceiver receiver = new DtmfReceiver(digit -> {
                throw new AssertionError(tone + " is heard as " + digit.key().symbol());
            });
            receiver.accept(sound(set, tone, 20_000));
            receiver.finish();
        }
    }

    @Test
    void aToneOfSoManySecondsEndsSoftlyAndExactly() {
        CadencePlayer player = new CadencePlayer();
        player.start(ToneSet.EUROPEAN.cadence(ProgressTone.DIAL), 100);
        short[] samples = new short[1000];
        player.addTo(samples);
        assertTrue(player.isIdle());
        assertTrue(isSilent(samples, 100, 125));
        assertTrue(Math.abs(samples[799]) < 50 && Math.abs(samples[790]) > 0);
        short[] more = new short[160];
        player.addTo(more);
        assertArrayEquals(new short[160], more);
    }

    @Test
    void aToneIsTheSameHoweverItIsTaken() {
        short[] whole = sound(ToneSet.AMERICAN, ProgressTone.SPECIAL_INFORMATION, 3000);
        CadencePlayer player = new CadencePlayer();
        player.start(ToneSet.AMERICAN.cadence(ProgressTone.SPECIAL_INFORMATION));
        for (int at = 0; at < whole.length; at += 160) {
            short[] frame = new short[160];
            player.addTo(frame);
            assertArrayEquals(java.util.Arrays.copyOfRange(whole, at, at + 160), frame);
        }
    }

    @Test
    void aToneIsAddedToWhatIsThere() {
        CadencePlayer player = new CadencePlayer();
        player.start(ToneSet.EUROPEAN.cadence(ProgressTone.DIAL));
        short[] loud = new short[400];
        java.util.Arrays.fill(loud, (short) 32_000);
        player.addTo(loud);
        for (short sample : loud) {
            assertTrue(sample > 20_000);
        }
    }

    @Test
    void causesSoundAsAnnexFHasThem() {
        assertEquals(Optional.of(ProgressTone.BUSY), ProgressTone.ofCause(17));
        assertEquals(Optional.of(ProgressTone.CONGESTION), ProgressTone.ofCause(42));
        assertEquals(Optional.of(ProgressTone.SPECIAL_INFORMATION), ProgressTone.ofCause(1));
        assertEquals(Optional.of(ProgressTone.CALL_DROPPED), ProgressTone.ofCause(41));
        assertEquals(Optional.empty(), ProgressTone.ofCause(16));
    }

    @Test
    void whatCannotSoundIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new ToneCadence(List.of()));
        assertThrows(IllegalArgumentException.class, () -> new ToneCadence(List.of(ToneCadence.pause(100))));
        assertThrows(IllegalArgumentException.class, () -> ToneCadence.burst(0, -10, 425.0));
        assertThrows(IllegalArgumentException.class, () -> ToneCadence.burst(100, 4, 425.0));
        assertThrows(IllegalArgumentException.class, () -> ToneCadence.burst(100, -10, 4000.0));
        assertThrows(IllegalArgumentException.class, () -> ToneSet.of("uk"));
    }
}
