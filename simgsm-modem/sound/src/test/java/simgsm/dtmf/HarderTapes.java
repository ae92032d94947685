package simgsm.dtmf;

import static simgsm.dtmf.Catalogue.ALL_KEYS;
import static simgsm.dtmf.Catalogue.corner;
import static simgsm.dtmf.Catalogue.harder;
import static simgsm.dtmf.Catalogue.level;
import static simgsm.dtmf.Catalogue.someKeys;
import static simgsm.dtmf.Catalogue.tail;
import static simgsm.dtmf.Catalogue.through;
import static simgsm.dtmf.Catalogue.timing;
import static simgsm.dtmf.Catalogue.twist;
import static simgsm.dtmf.Catalogue.voice;

import simgsm.speech.SpeechCodec;

/** What goes beyond the standards, but is met in the field. */
final class HarderTapes {
    private HarderTapes() {}

    static void add() {
        for (int snr : new int[] {3, 0, -3}) {
            harder("noise " + snr + " dB", tape -> {
                timing(tape, 50, 50);
                tape.digits(ALL_KEYS);
                tail(tape);
                tape.noiseBelowTones(snr);
            });
        }
        for (int twist : new int[] {-10, 10}) {
            harder("twist " + twist + " dB", tape -> {
                twist(tape, twist);
                tape.digits(ALL_KEYS);
            });
        }
        for (int dbm0 : new int[] {-40, -45}) {
            harder("level " + dbm0 + " dBm0", tape -> {
                level(tape, dbm0);
                tape.digits(ALL_KEYS);
            });
        }
        harder(
                "frequency 2 %",
                tape -> {
                    for (char key : ALL_KEYS.toCharArray()) {
                        corner(tape, 0.02);
                        tape.digits("" + key);
                    }
                });
        harder("tone 30 ms", tape -> {
            timing(tape, 30, 50);
            tape.digits(ALL_KEYS);
        });
        harder("pause 25 ms", tape -> {
            timing(tape, 50, 25);
            tape.digits("1122##DD" + someKeys(tape, 12));
        });
        harder("interruption 20 ms", tape -> {
            timing(tape, 110, 70);
            tape.dropOutMillis = 20;
            tape.digits(ALL_KEYS);
        });
        harder("dial tone 15 dB over", tape -> {
            level(tape, -25);
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.hum(350, -10).hum(440, -10);
        });
        harder("dial tone and noise", tape -> {
            level(tape, -15);
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.hum(425, -10).noiseBelowTones(9);
        });
        harder("heavy clipping", tape -> tape.digits(ALL_KEYS).clip(2000));
        for (int down : new int[] {9, 6, 3}) {
            harder("speech " + down + " dB under", tape -> {
                tape.digits(ALL_KEYS);
                voice(tape, -7 - down);
            });
        }
        harder("music 9 dB under", tape -> {
            tape.digits(ALL_KEYS);
            tape.add(Voices.atLevel(Voices.music(tape.random, tape.length()), -16));
        });
        harder("echo 6 dB", tape -> {
            timing(tape, 70, 70);
            tape.digits(ALL_KEYS).echo(tape.uniform(3, 20), 6);
        });
        harder("echo 15 dB after 40 ms", tape -> {
            timing(tape, 70, 90);
            tape.digits(ALL_KEYS).echo(tape.uniform(30, 60), 15);
        });
        harder("third tone 12 dB under", tape -> {
            tape.digits(ALL_KEYS);
            tape.hum(tape.uniform(1000, 3000), -19);
        });
        harder("impulses, many", tape -> {
            tape.digits(ALL_KEYS);
            tape.impulses(40, 20000);
        });
        harder("coloured noise 6 dB", tape -> {
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.add(Voices.atLevel(Voices.colouredNoise(tape.random, tape.length()), -13));
        });
        harder("frames lost", tape -> {
            timing(tape, 120, 80);
            tape.digits(ALL_KEYS);
            tape.frameLoss(0.03);
        });
        harder("slips, A-law, noise 12 dB", tape -> {
            timing(tape, 50, 50);
            tape.digits(ALL_KEYS);
            tape.noiseBelowTones(12).slips(60);
            through(tape, SpeechCodec.Kind.A_LAW);
        });
        harder("twist -8 dB, noise 9 dB", tape -> {
            timing(tape, 50, 50);
            twist(tape, -8);
            tape.digits(ALL_KEYS);
            tape.noiseBelowTones(9);
        });
    }
}
