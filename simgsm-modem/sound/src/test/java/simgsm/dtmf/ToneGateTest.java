package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import simgsm.tone.ToneLevel;

class ToneGateTest {
    private static final int HOPS = 40;

    /** Looks at 100 ms of two steady sines. @return the key at the end, or -1 */
    private static int look(double rowHertz, double rowDbm0, double columnHertz, double columnDbm0) {
        short[] samples = new short[20 + 20 * HOPS];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) Math.rint(ToneLevel.amplitude(rowDbm0) * Math.sin(2 * Math.PI * rowHertz * i / 8000)
                    + ToneLevel.amplitude(columnDbm0) * Math.sin(2 * Math.PI * columnHertz * i / 8000));
        }
        GoertzelBank bank = new GoertzelBank();
        ToneGate gate = new ToneGate();
        for (int hop = 0; hop < HOPS; hop++) {
            bank.accept(samples, 20 + 20 * hop);
        }
        int key = gate.look(bank, HOPS - 1);
        ToneLevels levels = gate.levels(bank);
        for (DtmfKey each : DtmfKey.values()) {
            boolean counts = levels.counts(each.row()) && levels.counts(4 + each.column());
            assertEquals(counts, each.ordinal() == key, "the levels tell of " + each);
        }
        return key;
    }

    @Test
    void twoTonesOfAKeyStandOutFarOffFrequencyAndTwisted() {
        for (DtmfKey key : DtmfKey.values()) {
            for (double error : new double[] {-0.018, 0, 0.018}) {
                int heard = look(key.rowHertz() * (1 + error), -20, key.columnHertz() * (1 - error), -12);
                assertEquals(key.ordinal(), heard, key + " at " + error);
            }
        }
    }

    @Test
    void whatIsNoPairDoesNotStandOut() {
        assertEquals(-1, look(770, -10, 770, -10), "a single tone");
        assertEquals(-1, look(697, -10, 852, -10), "two rows");
        assertEquals(-1, look(770, -55, 1336, -55), "too weak");
        assertEquals(-1, look(770, -10, 1336, -30), "far too twisted");
        assertEquals(-1, look(350, -10, 440, -10), "dial tone");
    }
}
