package simgsm.dtmf;

import static simgsm.dtmf.Catalogue.ALL_KEYS;
import static simgsm.dtmf.Catalogue.corner;
import static simgsm.dtmf.Catalogue.harder;
import static simgsm.dtmf.Catalogue.level;
import static simgsm.dtmf.Catalogue.required;
import static simgsm.dtmf.Catalogue.sign;
import static simgsm.dtmf.Catalogue.someKeys;
import static simgsm.dtmf.Catalogue.tail;
import static simgsm.dtmf.Catalogue.through;
import static simgsm.dtmf.Catalogue.timing;
import static simgsm.dtmf.Catalogue.twist;
import static simgsm.dtmf.Catalogue.voice;

import simgsm.speech.SpeechCodec;

/** Keys as exchanges, old telephones, bad lines and sound files bring them: several troubles at a time. */
final class FieldTapes {
    private FieldTapes() {}

    static void add() {
        edges();
        senders();
        lines();
        noises();
        codecs();
        hard();
    }

    private static void edges() {
        required("from the first to the last sample", tape -> {
            timing(tape, tape.uniform(40, 60), 50);
            tape.digits(someKeys(tape, 6));
            tape.trim(tape.starts.get(0), tape.length() - 400);
        });
        required("one key, alone in its file", tape -> {
            timing(tape, tape.uniform(40, 400), 0);
            tape.digits(someKeys(tape, 1));
            tape.trim(tape.starts.get(0), tape.length());
        });
        required("same key, 40 ms and 40 ms", tape -> {
            timing(tape, 40, 40);
            tape.digits(someKeys(tape, 1).repeat(12));
        });
        required("same key, 35 ms and 30 ms", tape -> {
            timing(tape, 35, 30);
            tape.digits(someKeys(tape, 1).repeat(12));
        });
        required("93 ms a key", tape -> {
            timing(tape, 46.5, 46.5);
            tape.digits(someKeys(tape, 24));
        });
        required("bursts of 50 ms at all limits", tape -> {
            timing(tape, 50, 50);
            for (char key : ALL_KEYS.toCharArray()) {
                level(tape, tape.uniform(-25, 0));
                twist(tape, tape.uniform(-8, 4));
                corner(tape, 0.015);
                tape.digits("" + key);
            }
        });
        required("interruption 10 ms in 60 ms", tape -> {
            timing(tape, 60, 60);
            tape.dropOutMillis = 10;
            tape.digits(ALL_KEYS);
        });
        required("dip of 15 ms to -20 dB, in noise", tape -> {
            timing(tape, 100, 60);
            tape.dropOutMillis = 15;
            tape.dropOutRemains = 0.1;
            tape.digits(ALL_KEYS);
            tape.noiseBelowTones(20);
        });
        required("ramps of 10 ms", tape -> {
            timing(tape, 60, 50);
            tape.rampMillis = 10;
            tape.digits(ALL_KEYS);
        });
    }

    private static void senders() {
        required("distorted sender", tape -> {
            level(tape, -6);
            tape.digits(ALL_KEYS).bend(0.08 * sign(tape), 0.15 * sign(tape));
        });
        required("over full scale", tape -> {
            timing(tape, 60, 60);
            level(tape, 0);
            tape.digits(ALL_KEYS).gain(tape.uniform(3, 9)).clip(32767);
        });
        required("full scale", tape -> {
            level(tape, -3);
            tape.digits(ALL_KEYS);
        });
        required("8-bit file", tape -> {
            level(tape, tape.uniform(-24, -6));
            tape.digits(ALL_KEYS).coarse(8);
        });
        required("flutter", tape -> tape.digits(ALL_KEYS).flutter(tape.uniform(2, 8), 2));
        required("third tone 16 dB under", tape -> {
            timing(tape, 60, 60);
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.hum(tape.uniform(300, 3400), -26);
        });
    }

    private static void lines() {
        required("telephone band", tape -> {
            timing(tape, 50, 50);
            level(tape, tape.uniform(-25, -3));
            twist(tape, tape.uniform(-6, 4));
            tape.digits(ALL_KEYS).telephoneBand();
        });
        required("hum with harmonics", tape -> {
            timing(tape, 60, 60);
            double mains = tape.random.nextBoolean() ? 50 : 60;
            level(tape, -12);
            tape.digits(ALL_KEYS);
            for (int h = 1; h <= 15; h++) {
                tape.hum(h * mains, -10 - 20 * Math.log10(h) - (h % 2 == 0 ? 12 : 0) - (h > 4 ? 8 : 0));
            }
        });
        required("strong hum", tape -> {
            level(tape, -18);
            tape.digits(ALL_KEYS).hum(tape.random.nextBoolean() ? 50 : 60, 0);
        });
        required("direct current and noise", tape -> {
            timing(tape, 50, 50);
            tape.digits(ALL_KEYS).noiseBelowTones(15).offset(sign(tape) * tape.uniform(1000, 12000));
        });
        for (double[] hertz : new double[][] {{350, 440}, {350, 450}, {400}, {425}, {440}, {400, 450}}) {
            required("dial tone as loud, 50 ms, " + java.util.Arrays.toString(hertz), tape -> {
                timing(tape, 50, 50);
                level(tape, tape.uniform(-20, -8));
                tape.digits(ALL_KEYS);
                tail(tape);
                for (double h : hertz) {
                    tape.hum(h, tape.rowDbm0 + tape.uniform(0, 3));
                }
            });
        }
        required("dial tone until the first key", tape -> {
            timing(tape, 60, 60);
            double[] dial = new double[tape.length()];
            tape.digits(someKeys(tape, 10));
            tape.add(Voices.atLevel(Voices.cadence(tape.random, dial.length, new double[] {350, 440}, 5000), -10));
        });
        required("echo of 10 dB, 40 ms", tape -> {
            timing(tape, 40, 40);
            tape.digits(ALL_KEYS + "1155##").echo(tape.uniform(1, 15), 10);
        });
        required("a room", tape -> {
            timing(tape, 80, 80);
            tape.digits(ALL_KEYS).room(60, 12);
        });
        required("level jumps of 25 dB, 45 ms", tape -> {
            timing(tape, 45, 45);
            boolean loud = true;
            for (char key : (ALL_KEYS + "5533").toCharArray()) {
                level(tape, loud ? -4 : -29);
                loud = !loud;
                tape.digits("" + key);
            }
        });
        required("slips once a second", tape -> {
            timing(tape, 60, 60);
            tape.digits(ALL_KEYS).slips(1000);
        });
        required("slips of 8 samples", tape -> {
            timing(tape, 80, 80);
            tape.digits(ALL_KEYS).jumps(700, 8);
        });
    }

    private static void noises() {
        for (int snr : new int[] {20, 15, 12}) {
            required("noise " + snr + " dB, 40 ms", tape -> {
                timing(tape, 40, 40);
                level(tape, tape.uniform(-30, -6));
                tape.digits(ALL_KEYS);
                tail(tape);
                tape.noiseBelowTones(snr);
            });
        }
        required(
                "noise 15 dB, 1.5 %, twist",
                tape -> {
                    timing(tape, 50, 50);
                    for (char key : ALL_KEYS.toCharArray()) {
                        level(tape, -12);
                        twist(tape, tape.uniform(-8, 4));
                        corner(tape, 0.015);
                        tape.digits("" + key);
                    }
                    tail(tape);
                    tape.noise(-27);
                });
        required("noise 12 dB below the weaker tone", tape -> {
            timing(tape, 60, 60);
            twist(tape, tape.random.nextBoolean() ? 6 : -6);
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.noise(Math.min(tape.rowDbm0, tape.columnDbm0) - 12);
        });
        required("coloured noise 15 dB", tape -> {
            timing(tape, 60, 60);
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.add(Voices.atLevel(Voices.colouredNoise(tape.random, tape.length()), -22));
        });
        required("clicks of one sample", tape -> {
            timing(tape, 60, 60);
            tape.digits(ALL_KEYS);
            for (int k = tape.length() / 800; k > 0; k--) {
                tape.sound[tape.random.nextInt(tape.length())] = 30000 * sign(tape);
            }
        });
        required("crackle", tape -> {
            timing(tape, 100, 80);
            tape.digits(ALL_KEYS).crackle(4, 2, -3);
        });
        required("babble 15 dB under", tape -> {
            timing(tape, 70, 70);
            tape.digits(ALL_KEYS);
            double[] babble = new double[tape.length()];
            for (int k = 0; k < 5; k++) {
                double[] one = Talkers.talk(tape.random, babble.length);
                for (int i = 0; i < babble.length; i++) {
                    babble[i] += one[i];
                }
            }
            tape.add(Voices.atLevel(babble, -22));
        });
        required("another voice 15 dB under", tape -> {
            timing(tape, 80, 80);
            tape.digits(ALL_KEYS);
            tape.add(Voices.atLevel(Talkers.talk(tape.random, tape.length()), -22));
        });
    }

    private static void codecs() {
        required("A-law, four times", tape -> {
            timing(tape, 50, 50);
            level(tape, tape.uniform(-30, -3));
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.A_LAW);
            through(tape.gain(-1), SpeechCodec.Kind.MU_LAW);
            through(tape.gain(-1), SpeechCodec.Kind.A_LAW);
            through(tape.gain(2), SpeechCodec.Kind.MU_LAW);
        });
        required("A-law at -36 dBm0, noise", tape -> {
            timing(tape, 60, 60);
            level(tape, -36);
            tape.digits(ALL_KEYS).noise(-55);
            through(tape, SpeechCodec.Kind.A_LAW);
        });
        required("GSM, noise 20 dB", tape -> {
            timing(tape, 80, 80);
            tape.digits(ALL_KEYS).noiseBelowTones(20);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        required("GSM, orders", tape -> {
            timing(tape, 100, 100);
            level(tape, tape.uniform(-14, -6));
            String[] orders = {"**#**20**", "***#9035", "*#9*05*0#", "**#**1*5**", "#*0*#90**"};
            tape.digits(orders[tape.random.nextInt(orders.length)]);
            tape.silence(tape.uniform(0, 20));
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
            through(tape, SpeechCodec.Kind.A_LAW);
        });
    }

    private static void hard() {
        harder("GSM, 50 ms", tape -> {
            timing(tape, 50, 60);
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        harder("GSM three times, 100 ms", tape -> {
            timing(tape, 100, 100);
            tape.digits(ALL_KEYS);
            for (int k = 0; k < 3; k++) {
                through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
                tape.trim(37, tape.length());
            }
        });
        harder("dial tone 6 dB over, noise 12 dB", tape -> {
            timing(tape, 50, 50);
            level(tape, -19);
            tape.digits(ALL_KEYS).noiseBelowTones(12);
            tail(tape);
            tape.hum(350, -13).hum(440, -13);
        });
        harder("gain step of 6 dB in the tone", tape -> {
            timing(tape, 90, 60);
            tape.digits(ALL_KEYS);
            for (int start : tape.starts) {
                double step = Math.pow(10, sign(tape) * 6 / 20);
                int from = start + (int) (8 * tape.uniform(20, 60));
                for (int i = from; i < start + 90 * 8; i++) {
                    tape.sound[i] *= step;
                }
            }
        });
        harder("slips every 40 ms", tape -> {
            timing(tape, 70, 70);
            tape.digits(ALL_KEYS).slips(40);
        });
        harder("jumps of 10 ms", tape -> {
            timing(tape, 100, 100);
            tape.digits(ALL_KEYS).jumps(600, 80);
        });
        harder("another voice 9 dB under", tape -> {
            tape.digits(ALL_KEYS);
            tape.add(Voices.atLevel(Talkers.talk(tape.random, tape.length()), -16));
        });
        harder("voice 9 dB under, GSM", tape -> {
            timing(tape, 100, 100);
            tape.digits(ALL_KEYS);
            voice(tape, -16);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        harder("noise 9 dB, 40 ms", tape -> {
            timing(tape, 40, 40);
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.noiseBelowTones(9);
        });
        harder(
                "noise 6 dB, 1.5 %",
                tape -> {
                    timing(tape, 60, 60);
                    for (char key : ALL_KEYS.toCharArray()) {
                        corner(tape, 0.015);
                        tape.digits("" + key);
                    }
                    tail(tape);
                    tape.noiseBelowTones(6);
                });
        harder("clipped by 20 dB, A-law", tape -> {
            tape.digits(ALL_KEYS).clip(1400);
            through(tape, SpeechCodec.Kind.A_LAW);
        });
        harder("hum and direct current and noise", tape -> {
            level(tape, -20);
            tape.digits(ALL_KEYS).noiseBelowTones(12).hum(50, -8).offset(3000);
        });
        harder("echo of 6 dB after 35 ms", tape -> {
            timing(tape, 80, 120);
            tape.digits(ALL_KEYS).echo(35, 6);
        });
    }
}
