package simgsm.dtmf;

import static simgsm.dtmf.Catalogue.ALL_KEYS;
import static simgsm.dtmf.Catalogue.level;
import static simgsm.dtmf.Catalogue.tail;
import static simgsm.dtmf.Catalogue.through;
import static simgsm.dtmf.Catalogue.timing;
import static simgsm.dtmf.Catalogue.twist;

import java.util.List;
import java.util.function.BiConsumer;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneLevel;

/**
 * A tape of telephone lines worse than the standards allow: {@link #RECORDINGS} recordings of 16 keys behind GSM 06.10
 * once and twice, in noise, in rooms, with echo, and over human or synthetic speech.
 */
final class LineTapes {
    static final int RECORDINGS = 163;

    private LineTapes() {}

    private record Line(String name, Catalogue.Recording recording) {}

    private static Catalogue.Recording keys(double tone, double pause, Catalogue.Recording line) {
        return tape -> {
            timing(tape, tone, pause);
            level(tape, tape.uniform(-20, -6));
            twist(tape, tape.uniform(-6, 4));
            Catalogue.corner(tape, tape.uniform(0, 0.012));
            tape.digits(ALL_KEYS);
            tail(tape);
            line.on(tape);
        };
    }

    private static void gsm(Tape tape, int times) {
        for (int i = 0; i < times; i++) {
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        }
    }

    private static List<Line> lines(short[] speech) {
        return List.of(
                new Line("GSM, 65 ms", keys(65, 65, tape -> gsm(tape, 1))),
                new Line("GSM twice, 80 ms", keys(80, 70, tape -> gsm(tape, 2))),
                new Line("noise 16 dB, GSM", keys(80, 80, tape -> gsm(tape.noiseBelowTones(16), 1))),
                new Line("noise 12 dB, GSM twice", keys(100, 80, tape -> gsm(tape.noiseBelowTones(12), 2))),
                new Line("noise 6 dB", keys(50, 50, tape -> tape.noiseBelowTones(6))),
                new Line("noise 3 dB", keys(60, 50, tape -> tape.noiseBelowTones(3))),
                new Line("speech 10 dB under", keys(80, 80, tape -> over(tape, speech, 10))),
                new Line("speech 6 dB under", keys(80, 80, tape -> over(tape, speech, 6))),
                new Line("speech 3 dB under", keys(100, 80, tape -> over(tape, speech, 3))),
                new Line("speech 10 dB under, GSM", keys(100, 80, tape -> gsm(over(tape, speech, 10), 1))),
                new Line("a room of 80 ms", keys(80, 80, tape -> tape.room(80, 8))),
                new Line("a room of 200 ms", keys(90, 110, tape -> tape.room(200, 9))),
                new Line(
                        "a room, noise 15 dB",
                        keys(80, 80, tape -> tape.room(100, 9).noiseBelowTones(15))),
                new Line("echo 8 dB, noise 12 dB, A-law", keys(70, 70, tape -> {
                    tape.echo(tape.uniform(3, 18), 8).noiseBelowTones(12);
                    through(tape, SpeechCodec.Kind.A_LAW);
                })),
                new Line(
                        "hum, noise 9 dB", keys(60, 60, tape -> tape.hum(50, -8).noiseBelowTones(9))),
                new Line("frames lost", keys(110, 90, tape -> gsm(tape.frameLoss(0.02), 1))));
    }

    /** @param speech laid under the keys of some lines */
    static void all(long seed, int recordings, short[] speech, BiConsumer<String, Tape> receiver) {
        List<Line> lines = lines(speech);
        for (int i = 0; i < recordings; i++) {
            Line line = lines.get(i % lines.size());
            Tape tape = new Tape(seed * 7919 + i);
            tape.silence(tape.uniform(200, 400));
            line.recording().on(tape);
            receiver.accept(line.name(), tape);
        }
    }

    /** Adds speech to the whole tape. @param decibels that it is weaker than the weaker tone */
    private static Tape over(Tape tape, short[] speech, int decibels) {
        double gain = ToneLevel.amplitude(Math.min(tape.rowDbm0, tape.columnDbm0) - decibels)
                / DisturbedTapes.rootMeanSquare(speech);
        DisturbedTapes.mix(tape, speech, gain, tape.length());
        return tape;
    }
}
