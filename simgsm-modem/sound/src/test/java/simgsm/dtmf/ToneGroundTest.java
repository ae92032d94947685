package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ToneGroundTest {
    private static final int END = 1024;

    /** The ground on which a key's tones are taken, looked at so many milliseconds after their beginning. */
    private static ToneGround ground(Tape tape, char symbol, int start, double millis) {
        short[] samples = tape.samples();
        ToneBank bank = new ToneBank();
        int hops = (int) ((start + 8 * millis) / ToneBank.HOP);
        short[] line = new short[END];
        int newest = hops * ToneBank.HOP;
        int from = Math.max(0, newest - END);
        System.arraycopy(samples, from, line, END - (newest - from), newest - from);
        short[] hop = new short[2 * ToneBank.HOP];
        for (int h = 0; h < hops; h++) {
            if (h > 0) {
                System.arraycopy(samples, (h - 1) * ToneBank.HOP, hop, 0, hop.length);
            } else {
                System.arraycopy(samples, 0, hop, ToneBank.HOP, ToneBank.HOP);
            }
            bank.accept(hop, ToneBank.HOP, 1);
            bank.shift(1);
        }
        ToneFit fit = new ToneFit();
        int key = DtmfKey.of(symbol).ordinal();
        int wait = fit.measure(bank, ToneBank.HISTORY - 1, hops - 1, ToneFit.SPAN, key, null, 10.2);
        return wait > 0 ? null : new ToneJudge().judge(fit, line, END, false);
    }

    private static Tape key(long seed) {
        Tape tape = new Tape(seed);
        tape.silence(100);
        return tape.digits("6");
    }

    @Test
    void aKeyInSilenceIsTakenBecauseItIsAlone() {
        assertEquals(ToneGround.ALONE, ground(key(1), '6', 800, 32));
    }

    @Test
    void aKeyOverHumAndDirectCurrentIsTakenBecauseItsBandIsClean() {
        assertEquals(ToneGround.CLEAN, ground(key(2).offset(4000).hum(50, -8), '6', 800, 32));
    }

    @Test
    void nothingIsTakenBeforeItHasSoundedLongEnoughNorFromSilence() {
        assertNull(ground(key(3), '6', 800, 20));
        assertNull(ground(new Tape(3).silence(200), '6', 800, 32));
    }

    @Test
    void aKeyThreeDecibelsAboveNoiseIsTakenBecauseTheNoiseExplainsAll() {
        int taken = 0;
        for (int seed = 0; seed < 20; seed++) {
            ToneGround ground = ground(key(seed).noiseBelowTones(3), '6', 800, 42);
            assertTrue(ground == null || ground == ToneGround.IN_NOISE || ground == ToneGround.IN_DIN, "" + ground);
            taken += ground == null ? 0 : 1;
        }
        assertTrue(taken >= 12, taken + " of 20");
    }

    @Test
    void everyGroundIsNeededBySomeKindOfRecording() {
        Map<ToneGround, String> kinds = new EnumMap<>(ToneGround.class);
        kinds.put(ToneGround.SETTLED, "GSM three times, 100 ms");
        kinds.put(ToneGround.SETTLING, "GSM, twist and error");
        kinds.put(ToneGround.IN_DIN, "coloured noise 6 dB");
        kinds.put(ToneGround.OVER_LINES, "speech 6 dB under");
        kinds.put(ToneGround.HALF_COVERED, "heavy clipping");
        kinds.forEach((ground, name) -> assertTrue(isUsed(ground, name), ground + " in " + name));
    }

    private static boolean isUsed(ToneGround ground, String name) {
        Catalogue.Kind kind = Catalogue.kinds().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow();
        for (Tape tape : Catalogue.tapes(kind, 12, 400)) {
            List<Integer> starts = tape.starts;
            for (int i = 0; i < starts.size(); i++) {
                for (double millis = 28; millis < 45; millis += 2.5) {
                    if (ground(tape, tape.expected.charAt(i), starts.get(i), millis) == ground) {
                        return true;
                    }
                }
            }
        }
        return false;
    }
}
