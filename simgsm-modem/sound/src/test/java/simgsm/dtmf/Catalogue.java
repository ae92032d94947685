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

    interface Recording {
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

    static void required(String name, Recording recording) {
        kind(Grade.REQUIRED, name, recording);
    }

    static void harder(String name, Recording recording) {
        kind(Grade.HARDER, name, recording);
    }

    static void silent(String name, Recording recording) {
        kind(Grade.SILENT, name, recording);
    }

    static String someKeys(Tape tape, int count) {
        StringBuilder keys = new StringBuilder();
        for (int i = 0; i < count; i++) {
            keys.append(ALL_KEYS.charAt(tape.random.nextInt(16)));
        }
        return keys.toString();
    }

    static double sign(Tape tape) {
        return tape.random.nextBoolean() ? 1 : -1;
    }

    static void timing(Tape tape, double tone, double pause) {
        tape.toneMillis = tone;
        tape.pauseMillis = pause;
    }

    static void level(Tape tape, double dbm0) {
        tape.rowDbm0 = dbm0;
        tape.columnDbm0 = dbm0;
    }

    /** High group over low by so much, the louder one at the level that both had. */
    static void twist(Tape tape, double decibels) {
        double loud = tape.rowDbm0;
        tape.rowDbm0 = decibels > 0 ? loud - decibels : loud;
        tape.columnDbm0 = decibels > 0 ? loud : loud + decibels;
    }

    static void corner(Tape tape, double error) {
        tape.rowError = error * sign(tape);
        tape.columnError = error * sign(tape);
    }

    static void tail(Tape tape) {
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

    static void voice(Tape tape, double dbm0) {
        tape.add(Voices.atLevel(Voices.speech(tape.random, tape.length()), dbm0));
    }

    static {
        plain();
        line();
        codecs();
        HarderTapes.add();
        FieldTapes.add();
        DecoyTapes.add();
        TalkOffTapes.add();
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

    static List<Tape> tapes(Kind kind, int count, long seed) {
        List<Tape> tapes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            tapes.add(kind.maker().apply(seed + i));
        }
        return tapes;
    }
}
