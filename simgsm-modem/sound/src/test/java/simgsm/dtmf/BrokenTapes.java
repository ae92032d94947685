package simgsm.dtmf;

import simgsm.tone.ToneLevel;

/** Keys whose tone breaks off and goes on weaker, keys with an early echo, and keys that begin too loud: each is one key. */
final class BrokenTapes {
    static final int KEYS = 32;

    private BrokenTapes() {}

    /** A tone, a gap, and the same key's tone again, weaker. */
    static Tape broken(long seed, int firstMillis, int gapMillis, int secondMillis, int drop) {
        Tape tape = new Tape(seed);
        tape.silence(tape.uniform(200, 203));
        for (char key : Catalogue.someKeys(tape, KEYS).toCharArray()) {
            double level = tape.uniform(-12, -6);
            Catalogue.level(tape, level);
            Catalogue.timing(tape, firstMillis, gapMillis);
            tape.digits("" + key);
            Catalogue.level(tape, level - drop);
            Catalogue.timing(tape, secondMillis, tape.uniform(100, 105));
            tape.decoys("" + key);
        }
        return tape.silence(200);
    }

    /** Keys of 100 ms. */
    static Tape echo(long seed, int pauseMillis, int delayMillis, int drop) {
        Tape tape = new Tape(seed);
        tape.silence(tape.uniform(200, 203));
        Catalogue.timing(tape, 100, pauseMillis);
        tape.digits(Catalogue.someKeys(tape, KEYS));
        return tape.silence(200).echo(delayMillis, drop);
    }

    /** Keys of 300 ms whose beginning is so loud that it is limited. */
    static Tape limited(long seed, int millis, int drop) {
        Tape tape = new Tape(seed);
        tape.silence(tape.uniform(200, 203));
        Catalogue.level(tape, -6 - drop);
        Catalogue.timing(tape, 300, 100);
        tape.digits(Catalogue.someKeys(tape, KEYS));
        double peak = ToneLevel.amplitude(-6);
        for (int start : tape.starts) {
            for (int k = start; k < start + millis * 8; k++) {
                tape.sound[k] = Math.signum(tape.sound[k]) * peak;
            }
        }
        return tape.silence(200);
    }

    /** The same key twice, the second weaker: two keys. */
    static Tape twice(long seed, int pauseMillis, int drop) {
        Tape tape = new Tape(seed);
        tape.silence(tape.uniform(200, 203));
        for (char key : Catalogue.someKeys(tape, KEYS).toCharArray()) {
            double level = tape.uniform(-12, -6);
            Catalogue.level(tape, level);
            Catalogue.timing(tape, 70, pauseMillis);
            tape.digits("" + key);
            Catalogue.level(tape, level - drop);
            Catalogue.timing(tape, 100, tape.uniform(100, 105));
            tape.digits("" + key);
        }
        return tape.silence(200);
    }
}
