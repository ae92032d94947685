package simgsm.dtmf;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import simgsm.speech.SpeechCodec;

/**
 * The kinds of recordings that a receiver is tried with, each from a seed: what the standards and plain use require, what
 * is harder, and what must not be heard. Levels, limits and names after ITU-T Q.24, ETSI ES 201 235-3 and the sides of the
 * Mitel test tape.
 */
final class Catalogue {
    enum Grade {
        REQUIRED,
        HARDER,
        /** Nothing may be heard. */
        SILENT
    }

    record Kind(String name, Grade grade, Function<Long, Tape> maker) {}

    static final String ALL_KEYS = "1234567890*#ABCD";

    private static final List<Kind> KINDS = new ArrayList<>();

    private Catalogue() {}

    static List<Kind> kinds() {
        return KINDS;
    }

    private interface Recording {
        void on(Tape tape);
    }

    private static void kind(Grade grade, String name, Recording recording) {
        KINDS.add(new Kind(name, grade, seed -> {
            Tape tape = new Tape(seed * 7919 + name.hashCode());
            tape.silence(tape.uniform(150, 400));
            recording.on(tape);
            return tape;
        }));
    }

    private static void required(String name, Recording recording) {
        kind(Grade.REQUIRED, name, recording);
    }

    private static void harder(String name, Recording recording) {
        kind(Grade.HARDER, name, recording);
    }

    private static void silent(String name, Recording recording) {
        kind(Grade.SILENT, name, recording);
    }

    private static String someKeys(Tape tape, int count) {
        StringBuilder keys = new StringBuilder();
        for (int i = 0; i < count; i++) {
            keys.append(ALL_KEYS.charAt(tape.random.nextInt(16)));
        }
        return keys.toString();
    }

    private static double sign(Tape tape) {
        return tape.random.nextBoolean() ? 1 : -1;
    }

    private static void timing(Tape tape, double tone, double pause) {
        tape.toneMillis = tone;
        tape.pauseMillis = pause;
    }

    private static void level(Tape tape, double dbm0) {
        tape.rowDbm0 = dbm0;
        tape.columnDbm0 = dbm0;
    }

    /** High group over low by so much, the louder one at the level that both had. */
    private static void twist(Tape tape, double decibels) {
        double loud = tape.rowDbm0;
        tape.rowDbm0 = decibels > 0 ? loud - decibels : loud;
        tape.columnDbm0 = decibels > 0 ? loud : loud + decibels;
    }

    private static void corner(Tape tape, double error) {
        tape.rowError = error * sign(tape);
        tape.columnError = error * sign(tape);
    }

    private static void tail(Tape tape) {
        tape.silence(200);
    }

    static void through(Tape tape, SpeechCodec.Kind kind) {
        short[] in = Arrays.copyOf(tape.samples(), (tape.length() + 159) / 160 * 160);
        short[] out = new short[in.length];
        SpeechCodec encoder = kind.open();
        SpeechCodec decoder = kind.open();
        for (int i = 0; i < in.length; i += 160) {
            short[] frame = decoder.decode(encoder.encode(Arrays.copyOfRange(in, i, i + 160)));
            System.arraycopy(frame, 0, out, i, 160);
        }
        tape.replace(out);
    }

    private static void voice(Tape tape, double dbm0) {
        tape.add(Voices.atLevel(Voices.speech(tape.random, tape.length()), dbm0));
    }

    static {
        plain();
        line();
        codecs();
        hard();
        wrong();
        talkOff();
    }

    private static void plain() {
        required("all keys", tape -> tape.digits(ALL_KEYS));
        required(
                "frequency 1.5 %",
                tape -> {
                    for (char key : ALL_KEYS.toCharArray()) {
                        corner(tape, 0.015);
                        tape.digits("" + key);
                    }
                });
        required(
                "frequency 1.8 %",
                tape -> {
                    for (char key : ALL_KEYS.toCharArray()) {
                        corner(tape, 0.018);
                        tape.digits("" + key);
                    }
                });
        for (int twist : new int[] {-8, -4, 4, 8}) {
            required("twist " + twist + " dB", tape -> {
                twist(tape, twist);
                tape.digits(ALL_KEYS);
            });
        }
        for (int dbm0 : new int[] {0, -3, -15, -25, -30, -36}) {
            required("level " + dbm0 + " dBm0", tape -> {
                level(tape, dbm0);
                tape.digits(ALL_KEYS);
            });
        }
        required("tone 40 pause 40 ms", tape -> {
            timing(tape, 40, 40);
            tape.digits(ALL_KEYS + someKeys(tape, 8));
        });
        required("tone 35 ms", tape -> {
            timing(tape, 35, 45);
            tape.digits(ALL_KEYS + someKeys(tape, 8));
        });
        required("pause 30 ms", tape -> {
            timing(tape, 45, 30);
            tape.digits("1122##DD" + someKeys(tape, 12));
        });
        required("long tones", tape -> {
            timing(tape, 700, 300);
            tape.digits(someKeys(tape, 4));
        });
        required("no gap", tape -> {
            timing(tape, 60, 0);
            tape.digits("1593*0#A8D").silence(100);
        });
        for (int hole : new int[] {5, 10, 15}) {
            required("interruption " + hole + " ms", tape -> {
                timing(tape, 90 + hole, 70);
                tape.dropOutMillis = hole;
                tape.digits(ALL_KEYS);
            });
        }
        required("ramps", tape -> {
            timing(tape, 55, 55);
            tape.rampMillis = 5;
            tape.digits(ALL_KEYS);
        });
    }

    private static void line() {
        for (int snr : new int[] {20, 15, 12, 9, 6}) {
            required("noise " + snr + " dB", tape -> {
                timing(tape, 50, 50);
                tape.digits(ALL_KEYS);
                tail(tape);
                tape.noiseBelowTones(snr);
            });
        }
        required("noise 15 dB, everything at its limit", tape -> {
            timing(tape, 45, 45);
            for (char key : someKeys(tape, 12).toCharArray()) {
                corner(tape, 0.015);
                level(tape, tape.uniform(-30, -5));
                twist(tape, tape.uniform(-6, 4));
                tape.digits("" + key);
            }
            level(tape, -24);
            tape.noise(-50);
        });
        required("direct current", tape -> tape.digits(ALL_KEYS).offset(sign(tape) * tape.uniform(500, 8000)));
        required("mains hum", tape -> {
            double mains = tape.random.nextBoolean() ? 50 : 60;
            tape.digits(ALL_KEYS).hum(mains, -8).hum(3 * mains, -20).hum(5 * mains, -26);
        });
        required("dial tone 350+440", tape -> {
            level(tape, tape.uniform(-16, -6));
            tape.digits(ALL_KEYS);
            tail(tape);
            tape.hum(350, -13).hum(440, -13);
        });
        for (double hertz : new double[] {400, 425}) {
            required("dial tone " + (int) hertz, tape -> {
                level(tape, tape.uniform(-16, -6));
                tape.digits(ALL_KEYS);
                tail(tape);
                tape.hum(hertz, -10);
            });
        }
        required("impulses", tape -> {
            tape.digits(ALL_KEYS);
            tape.impulses(12, 12000);
        });
        required("clipping", tape -> {
            level(tape, -6);
            tape.digits(ALL_KEYS).clip(tape.uniform(9000, 14000));
        });
        required("speech 15 dB under", tape -> {
            tape.digits(ALL_KEYS);
            voice(tape, -22);
        });
        required("echo", tape -> {
            timing(tape, 60, 60);
            tape.digits(ALL_KEYS).echo(tape.uniform(3, 20), tape.uniform(10, 16));
        });
        required("level jumps", tape -> {
            for (char key : (ALL_KEYS + "5533").toCharArray()) {
                level(tape, tape.uniform(-30, -4));
                tape.digits("" + key);
            }
        });
        required("sample slips", tape -> {
            tape.digits(ALL_KEYS);
            tape.slips(130);
        });
    }

    private static void codecs() {
        required("A-law", tape -> {
            level(tape, tape.uniform(-30, -6));
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.A_LAW);
        });
        required("mu-law", tape -> {
            level(tape, tape.uniform(-30, -6));
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.MU_LAW);
        });
        required("GSM", tape -> {
            timing(tape, tape.uniform(70, 120), tape.uniform(60, 120));
            level(tape, tape.uniform(-16, -6));
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        required("GSM in tandem", tape -> {
            timing(tape, 100, 100);
            tape.digits("**#**20**" + someKeys(tape, 8));
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
            tape.silence(10);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        harder("GSM, 65 ms at -20 dBm0", tape -> {
            timing(tape, 65, 65);
            level(tape, -20);
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        harder("GSM, twist and error", tape -> {
            timing(tape, 80, 70);
            for (char key : ALL_KEYS.toCharArray()) {
                corner(tape, 0.01);
                level(tape, tape.uniform(-20, -6));
                twist(tape, tape.uniform(-6, 4));
                tape.digits("" + key);
            }
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        harder("GSM in tandem, 70 ms", tape -> {
            timing(tape, 70, 65);
            tape.digits(ALL_KEYS);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
            through(tape, SpeechCodec.Kind.A_LAW);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
    }

    private static void hard() {
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

    private static void wrong() {
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
    }

    private static final double[][] NETWORK_TONES = {
        {350, 440},
        {440, 480},
        {480, 620},
        {425},
        {400},
        {450},
        {400, 450},
        {1400},
        {1100},
        {2100},
        {440},
        {950},
        {1400, 1800},
        {950, 1400},
        {2130, 2750},
        {1300},
        {914, 1429},
        {985, 1371},
        {2600},
        {330, 440},
        {1000},
        {700, 900},
        {1100, 1700},
        {540, 660}
    };

    private static void talkOff() {
        silent("network tones", tape -> {
            double[] hertz = NETWORK_TONES[tape.random.nextInt(NETWORK_TONES.length)];
            tape.silence(8000);
            int[] cadence = {30 + tape.random.nextInt(600), 30 + tape.random.nextInt(600)};
            tape.add(Voices.atLevel(Voices.cadence(tape.random, tape.length(), hertz, cadence), tape.uniform(-25, -5)));
        });
        silent("speech", tape -> {
            tape.silence(20000);
            voice(tape, tape.uniform(-30, -10));
        });
        silent("music", tape -> {
            tape.silence(20000);
            tape.add(Voices.atLevel(Voices.music(tape.random, tape.length()), tape.uniform(-30, -10)));
        });
        silent("sirens", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Voices.siren(tape.random, tape.length()), tape.uniform(-30, -8)));
        });
        silent("noise", tape -> {
            tape.silence(10000);
            tape.noise(tape.uniform(-40, -5));
        });
        silent("coloured noise", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Voices.colouredNoise(tape.random, tape.length()), tape.uniform(-30, -8)));
        });
        silent("speech through GSM", tape -> {
            tape.silence(10000);
            voice(tape, tape.uniform(-30, -10));
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        silent("speech in noise", tape -> {
            tape.silence(10000);
            double level = tape.uniform(-30, -12);
            voice(tape, level);
            tape.noise(level - tape.uniform(3, 25));
        });
    }

    static List<Tape> tapes(Kind kind, int count, long seed) {
        List<Tape> tapes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            tapes.add(kind.maker().apply(seed + i));
        }
        return tapes;
    }
}
