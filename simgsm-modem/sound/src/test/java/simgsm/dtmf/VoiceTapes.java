package simgsm.dtmf;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneLevel;

/** Sound without keys: recorded voices behind what lines and recorders do to them, and sustained vowels by synthesis. */
final class VoiceTapes {
    /** Formants of twelve vowels: frequencies in hertz. */
    private static final double[][] VOWELS = {
        {770, 1210, 2500}, {710, 1100, 2450}, {590, 880, 2540}, {580, 1800, 2600}, {450, 800, 2500},
        {860, 1550, 2450}, {640, 1200, 2390}, {500, 1500, 2500}, {700, 1350, 2600}, {850, 1480, 2700},
        {940, 1340, 2700}, {690, 1640, 2600}
    };

    private VoiceTapes() {}

    /** The speech as it is and behind eleven treatments, by name. */
    static Map<String, short[]> treated(short[] speech) {
        Map<String, short[]> all = new LinkedHashMap<>();
        all.put("as it is", speech);
        all.put("A-law", line(speech, tape -> Catalogue.through(tape, SpeechCodec.Kind.A_LAW)));
        all.put("GSM", line(speech, tape -> Catalogue.through(tape, SpeechCodec.Kind.GSM_FULL_RATE)));
        all.put("GSM twice", line(speech, tape -> {
            Catalogue.through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
            Catalogue.through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        }));
        all.put("telephone band", line(speech, Tape::telephoneBand));
        double rms = DisturbedTapes.rootMeanSquare(speech);
        all.put("noise 15 dB", line(speech, tape -> tape.noise(ToneLevel.dbm0(rms * Math.sqrt(2)) - 15)));
        all.put("louder, clipped", line(speech, tape -> tape.gain(12).clip(32767)));
        all.put("softer", line(speech, tape -> tape.gain(-12)));
        for (double speed : new double[] {0.87, 0.93, 1.07, 1.15}) {
            all.put("speed " + speed, atSpeed(speech, speed));
        }
        return all;
    }

    private static short[] line(short[] speech, Catalogue.Recording treatment) {
        Tape tape = new Tape(1);
        tape.silence(speech.length / 8.0);
        for (int i = 0; i < tape.length(); i++) {
            tape.sound[i] = speech[i];
        }
        treatment.on(tape);
        return tape.samples();
    }

    /** By cubic interpolation. */
    private static short[] atSpeed(short[] speech, double speed) {
        short[] out = new short[(int) ((speech.length - 4) / speed)];
        for (int i = 0; i < out.length; i++) {
            int at = (int) (i * speed);
            double t = i * speed - at;
            double a = speech[at];
            double b = speech[at + 1];
            double c = speech[at + 2];
            double d = speech[at + 3];
            double value = b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
            out[i] = (short) Math.max(-32768, Math.min(32767, Math.rint(value)));
        }
        return out;
    }

    /** Every vowel at one pitch, 350 ms each, by a train of harmonics through three resonances; the pitch is steady. */
    static short[] vowels(double pitchHertz, long seed) {
        Random random = new Random(seed);
        double[] sound = new double[VOWELS.length * 4000];
        for (int v = 0; v < VOWELS.length; v++) {
            double width = 50 + 70 * random.nextDouble();
            double tilt = 0.3 + 0.9 * random.nextDouble();
            for (int h = 1; h * pitchHertz < 3600; h++) {
                double gain = 0;
                for (int f = 0; f < 3; f++) {
                    double x = (h * pitchHertz - VOWELS[v][f]) / (width * (1 + 0.3 * f));
                    gain += 1 / Math.sqrt(1 + x * x) / (1 + f);
                }
                double phase = 2 * Math.PI * random.nextDouble();
                double step = 2 * Math.PI * h * pitchHertz / Tape.RATE;
                for (int i = 0; i < 2800; i++) {
                    double edge = Math.min(1, Math.min(i, 2800 - i) / 160.0);
                    sound[4000 * v + i] += edge * gain * Math.pow(h, -tilt) * Math.sin(phase + step * i);
                }
            }
        }
        Voices.atLevel(sound, -15);
        short[] samples = new short[sound.length];
        for (int i = 0; i < sound.length; i++) {
            samples[i] = (short) Math.max(-32768, Math.min(32767, Math.rint(sound[i])));
        }
        return samples;
    }
}
