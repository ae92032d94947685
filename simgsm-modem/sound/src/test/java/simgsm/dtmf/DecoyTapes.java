package simgsm.dtmf;

import static simgsm.dtmf.Catalogue.ALL_KEYS;
import static simgsm.dtmf.Catalogue.level;
import static simgsm.dtmf.Catalogue.sign;
import static simgsm.dtmf.Catalogue.silent;
import static simgsm.dtmf.Catalogue.someKeys;
import static simgsm.dtmf.Catalogue.through;
import static simgsm.dtmf.Catalogue.timing;
import static simgsm.dtmf.Catalogue.twist;

import simgsm.speech.SpeechCodec;

/** What sounds like keys but must not be taken for any (ITU-T Q.24). */
final class DecoyTapes {
    private DecoyTapes() {}

    static void add() {
        for (double error : new double[] {0.035, 0.03, 0.04, 0.05}) {
            silent("frequency " + 100 * error + " %", tape -> {
                for (char key : ALL_KEYS.toCharArray()) {
                    int which = tape.random.nextInt(3);
                    tape.rowError = which == 0 ? 0 : error * sign(tape);
                    tape.columnError = which == 1 ? 0 : error * sign(tape);
                    tape.decoys("" + key);
                }
            });
        }
        for (int millis : new int[] {10, 15, 20, 22, 23}) {
            silent("tones of " + millis + " ms", tape -> {
                timing(tape, millis, 60);
                level(tape, tape.uniform(-25, -3));
                tape.decoys(ALL_KEYS);
            });
        }
        for (int twist : new int[] {-20, -15, 15, 20}) {
            silent("twist " + twist + " dB", tape -> {
                level(tape, -3);
                twist(tape, twist);
                tape.decoys(ALL_KEYS);
            });
        }
        for (int dbm0 : new int[] {-55, -60}) {
            silent("level " + dbm0 + " dBm0", tape -> {
                level(tape, dbm0);
                tape.decoys(ALL_KEYS);
            });
        }
        silent("single tones", tape -> {
            for (char key : ALL_KEYS.toCharArray()) {
                boolean row = tape.random.nextBoolean();
                tape.rowDbm0 = row ? -6 : -100;
                tape.columnDbm0 = row ? -100 : -6;
                tape.decoys("" + key);
            }
        });
        silent("two of one group", tape -> {
            for (int i = 0; i < 16; i++) {
                boolean row = tape.random.nextBoolean();
                double[] group = row ? DtmfKey.ROW_HERTZ : DtmfKey.COLUMN_HERTZ;
                int at = tape.length();
                tape.silence(160);
                double[] beep = Voices.atLevel(
                        Voices.cadence(
                                tape.random,
                                640,
                                new double[] {group[tape.random.nextInt(2)], group[2 + tape.random.nextInt(2)]},
                                80,
                                80),
                        -8);
                for (int k = 0; k < beep.length; k++) {
                    tape.sound[at + k] += beep[k];
                }
            }
        });
        silent("two keys at once", tape -> {
            for (int i = 0; i < 12; i++) {
                int row = tape.random.nextInt(4);
                int column = tape.random.nextInt(4);
                int at = tape.length();
                tape.silence(160);
                double[] beep = Voices.atLevel(
                        Voices.cadence(
                                tape.random,
                                640,
                                new double[] {
                                    DtmfKey.ROW_HERTZ[row],
                                    DtmfKey.ROW_HERTZ[(row + 1 + tape.random.nextInt(3)) % 4],
                                    DtmfKey.COLUMN_HERTZ[column]
                                },
                                80,
                                80),
                        -8);
                for (int k = 0; k < beep.length; k++) {
                    tape.sound[at + k] += beep[k];
                }
            }
        });
        more();
    }

    private static void more() {
        for (double error : new double[] {0.03, 0.035}) {
            silent("frequency " + 100 * error + " %, one tone, 50 ms, noise", tape -> {
                timing(tape, 50, 50);
                for (char key : ALL_KEYS.toCharArray()) {
                    boolean row = tape.random.nextBoolean();
                    tape.rowError = row ? error * sign(tape) : 0;
                    tape.columnError = row ? 0 : error * sign(tape);
                    tape.decoys("" + key);
                }
                tape.noiseBelowTones(25);
            });
        }
        silent("tones of 22 ms, every phase, noise 20 dB", tape -> {
            timing(tape, 22, tape.uniform(40, 43));
            tape.decoys(someKeys(tape, 24)).noiseBelowTones(20);
        });
        silent("tones of 20 ms, noise 10 dB", tape -> {
            timing(tape, 20, 55);
            tape.decoys(someKeys(tape, 24)).noiseBelowTones(10);
        });
        silent("tones of 23 ms, twist, ramps", tape -> {
            timing(tape, 23, 45);
            twist(tape, tape.uniform(-6, 6));
            tape.rampMillis = tape.uniform(0, 3);
            tape.decoys(someKeys(tape, 24));
        });
        silent("tones of 20 ms through codecs", tape -> {
            timing(tape, 20, 60);
            tape.decoys(someKeys(tape, 24));
            through(tape, tape.random.nextBoolean() ? SpeechCodec.Kind.A_LAW : SpeechCodec.Kind.MU_LAW);
        });
        silent("one key, 20 ms, 30 ms pauses", tape -> {
            timing(tape, 20, 30);
            tape.decoys(someKeys(tape, 1).repeat(20));
        });
        for (int twist : new int[] {-15, 15}) {
            silent("twist " + twist + " dB, noise 25 dB", tape -> {
                timing(tape, 60, 60);
                level(tape, -3);
                twist(tape, twist);
                tape.decoys(ALL_KEYS).noiseBelowTones(25);
            });
        }
        silent("level -55 dBm0 in noise", tape -> {
            level(tape, -55);
            tape.decoys(ALL_KEYS).noiseBelowTones(15);
        });
        silent("single tones, distorted, noise", tape -> {
            for (char key : ALL_KEYS.toCharArray()) {
                boolean row = tape.random.nextBoolean();
                tape.rowDbm0 = row ? -6 : -100;
                tape.columnDbm0 = row ? -100 : -6;
                tape.decoys("" + key);
            }
            tape.bend(0.1, 0.2).noise(-35);
        });
    }
}
