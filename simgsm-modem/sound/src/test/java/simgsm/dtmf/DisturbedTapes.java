package simgsm.dtmf;

import java.util.List;
import java.util.Random;
import java.util.function.BiConsumer;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneLevel;

/** Keys whose beginning is disturbed, keys in noise before a codec, compliant keys at random, and keys over speech. */
final class DisturbedTapes {
    private DisturbedTapes() {}

    /** {@code count} recordings of each kind, with the kind's name. */
    static void all(long seed, int count, BiConsumer<String, Tape> receiver) {
        Random seeds = new Random(seed);
        for (int i = 0; i < count; i++) {
            for (int millis : new int[] {20, 40, 60, 80, 100, 150}) {
                for (int decibels : new int[] {0, 6}) {
                    receiver.accept(
                            "first " + millis + " ms in noise of +" + decibels + " dB",
                            noisyBeginning(seeds.nextLong(), millis, decibels));
                }
            }
            for (int millis : new int[] {30, 60, 100}) {
                receiver.accept("first " + millis + " ms limited", limitedBeginning(seeds.nextLong(), millis));
            }
            for (int decibels : new int[] {30, 25, 20, 16, 12}) {
                receiver.accept(
                        "noise " + decibels + " dB, GSM", noiseBeforeCodec(seeds.nextLong(), decibels, false, 1));
                if (decibels >= 16) {
                    receiver.accept(
                            "noise " + decibels + " dB, GSM, within Q.24",
                            noiseBeforeCodec(seeds.nextLong(), decibels, true, 1));
                }
            }
            receiver.accept("noise 25 dB, GSM twice", noiseBeforeCodec(seeds.nextLong(), 25, false, 2));
            for (int k = 0; k < 25; k++) {
                receiver.accept("compliant", compliant(seeds.nextLong()));
            }
        }
    }

    /** What no curve is fitted to: tones that are no keys, late echoes, and tones of the exchange under the keys. */
    static void others(long seed, int count, BiConsumer<String, Tape> receiver) {
        Random seeds = new Random(seed);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < 32; k++) {
                receiver.accept("not compliant", notCompliant(seeds.nextLong()));
            }
            receiver.accept("echo after 250 ms, 20 dB weaker", lateEcho(seeds.nextLong()));
            for (int decibels : new int[] {0, 6}) {
                receiver.accept(
                        "busy tone " + decibels + " dB louder than the keys", busyTone(seeds.nextLong(), decibels));
            }
        }
    }

    /** Level, twist and frequency anywhere within what Q.24 accepts, for every other recording; else as keys mostly come. */
    private static void anywhere(Tape tape) {
        if (tape.random.nextBoolean()) {
            Catalogue.level(tape, tape.uniform(-25, -3));
            Catalogue.twist(tape, tape.uniform(-8, 4));
            tape.rowError = tape.uniform(-0.018, 0.018);
            tape.columnError = tape.uniform(-0.018, 0.018);
        }
    }

    private static Tape held(long seed, int toneMillis) {
        Tape tape = new Tape(seed);
        tape.silence(300);
        anywhere(tape);
        Catalogue.timing(tape, toneMillis, 200);
        return tape;
    }

    static Tape noisyBeginning(long seed, int millis, int decibels) {
        Tape tape = held(seed, 500);
        tape.digits(Catalogue.someKeys(tape, 4));
        double sigma = ToneLevel.amplitude(Math.max(tape.rowDbm0, tape.columnDbm0) + decibels);
        for (int start : tape.starts) {
            for (int k = start; k < start + millis * 8; k++) {
                tape.sound[k] += sigma * tape.random.nextGaussian();
            }
        }
        return tape;
    }

    static Tape limitedBeginning(long seed, int millis) {
        Tape tape = held(seed, 500);
        tape.digits(Catalogue.someKeys(tape, 4));
        for (int start : tape.starts) {
            for (int k = start; k < start + millis * 8; k++) {
                tape.sound[k] = Math.signum(tape.sound[k]) * 2 * ToneLevel.amplitude(tape.rowDbm0);
            }
        }
        return tape;
    }

    static Tape noiseBeforeCodec(long seed, int decibels, boolean withinLimits, int codecs) {
        Tape tape = new Tape(seed);
        tape.silence(300);
        Catalogue.timing(tape, 100, 80);
        for (char key : Catalogue.someKeys(tape, 16).toCharArray()) {
            if (withinLimits) {
                Catalogue.level(tape, -13);
                Catalogue.twist(tape, tape.uniform(-2, 4));
                Catalogue.corner(tape, 0.01);
            }
            tape.digits("" + key);
        }
        tape.noiseBelowTones(decibels);
        for (int i = 0; i < codecs; i++) {
            Catalogue.through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        }
        return tape;
    }

    /** Eight keys anywhere within what Q.24 accepts: level, twist, frequency, length, interruption, echo, noise. */
    static Tape compliant(long seed) {
        Tape tape = new Tape(seed);
        tape.silence(tape.uniform(100, 300));
        double level = tape.uniform(-25, 0);
        for (char key : Catalogue.someKeys(tape, 8).toCharArray()) {
            Catalogue.timing(tape, tape.uniform(40, 120), tape.uniform(40, 120));
            Catalogue.level(tape, level);
            Catalogue.twist(tape, tape.uniform(-8, 4));
            tape.rowError = tape.uniform(-0.015, 0.015);
            tape.columnError = tape.uniform(-0.015, 0.015);
            boolean hole = tape.random.nextInt(3) == 0 && tape.toneMillis > 45;
            tape.dropOutMillis = hole ? tape.uniform(1, 10) : -1;
            tape.digits("" + key);
        }
        tape.silence(100);
        if (tape.random.nextBoolean()) {
            tape.echo(tape.uniform(1, 20), tape.uniform(10, 20));
        }
        if (tape.random.nextBoolean()) {
            tape.noise(level - 8 - tape.uniform(15, 30));
        }
        return tape;
    }

    /** Eight pairs of tones that Q.24 rejects: too short, too weak, twisted, off frequency, one tone, two of a group. */
    static Tape notCompliant(long seed) {
        Tape tape = new Tape(seed);
        tape.silence(tape.uniform(100, 300));
        double level = tape.uniform(-25, 0);
        for (char key : Catalogue.someKeys(tape, 8).toCharArray()) {
            Catalogue.timing(tape, tape.uniform(40, 120), tape.uniform(40, 120));
            Catalogue.level(tape, level);
            Catalogue.twist(tape, tape.uniform(-8, 4));
            tape.rowError = tape.uniform(-0.015, 0.015);
            tape.columnError = tape.uniform(-0.015, 0.015);
            switch (tape.random.nextInt(7)) {
                case 0 -> tape.toneMillis = tape.uniform(8, 23);
                case 1 -> Catalogue.level(tape, tape.uniform(-70, -56));
                case 2 -> Catalogue.twist(tape, 16 * Catalogue.sign(tape));
                case 3 -> tape.rowError = 0.035 * Catalogue.sign(tape);
                case 4 -> tape.columnError = 0.035 * Catalogue.sign(tape);
                case 5 -> tape.rowDbm0 = -100;
                default -> tape.columnError = 852.0 / DtmfKey.of(key).columnHertz() - 1;
            }
            tape.decoys("" + key);
        }
        tape.silence(100);
        if (tape.random.nextBoolean()) {
            tape.noise(level - 8 - tape.uniform(15, 50));
        }
        return tape;
    }

    static Tape lateEcho(long seed) {
        Tape tape = held(seed, 100);
        for (char key : Catalogue.someKeys(tape, 8).toCharArray()) {
            Catalogue.timing(tape, tape.uniform(50, 150), tape.uniform(50, 300));
            tape.digits("" + key);
        }
        tape.silence(400);
        return tape.echo(250, 20);
    }

    /** 480 and 620 Hz, North America's busy tone, under all keys. */
    static Tape busyTone(long seed, int decibels) {
        Tape tape = held(seed, 100);
        Catalogue.timing(tape, 100, 100);
        tape.digits(Catalogue.someKeys(tape, 8));
        double level = Math.max(tape.rowDbm0, tape.columnDbm0) + decibels;
        return tape.hum(480, level).hum(620, level);
    }

    /** Keys over speech that is 20 to 3 dB weaker, and held keys into which a voice still speaks. */
    static void over(long seed, int count, short[] speech, BiConsumer<String, Tape> receiver) {
        Random seeds = new Random(seed);
        double perSample = 1 / rootMeanSquare(speech);
        for (int i = 0; i < count; i++) {
            for (int decibels : List.of(20, 15, 10, 6, 3)) {
                double below = perSample * Math.pow(10, -decibels / 20.0);
                Tape tape = new Tape(seeds.nextLong());
                tape.silence(200);
                anywhere(tape);
                Catalogue.timing(tape, 100, 100);
                tape.digits(Catalogue.someKeys(tape, 12));
                mix(tape, speech, below * weaker(tape), tape.length());
                receiver.accept("over speech " + decibels + " dB weaker", tape);
                for (int millis : decibels > 6 ? List.<Integer>of() : List.of(60, 300)) {
                    Tape held = new Tape(seeds.nextLong());
                    held.silence(600);
                    anywhere(held);
                    Catalogue.timing(held, 1000, 400);
                    held.digits(Catalogue.someKeys(held, 1));
                    mix(held, speech, below * weaker(held), held.starts.get(0) + 8 * millis);
                    receiver.accept("voice " + decibels + " dB weaker stops after " + millis + " ms", held);
                }
            }
        }
    }

    /** Amplitude of the weaker tone. */
    private static double weaker(Tape tape) {
        return ToneLevel.amplitude(Math.min(tape.rowDbm0, tape.columnDbm0));
    }

    static double rootMeanSquare(short[] speech) {
        double sum = 0;
        long count = 0;
        for (short sample : speech) {
            if (Math.abs(sample) > 200) {
                sum += sample * sample;
                count++;
            }
        }
        return Math.sqrt(sum / Math.max(1, count));
    }

    static void mix(Tape tape, short[] speech, double gain, int until) {
        int from = tape.random.nextInt(Math.max(1, speech.length - until));
        for (int k = 0; k < until && from + k < speech.length; k++) {
            tape.sound[k] += gain * speech[from + k];
        }
    }
}
