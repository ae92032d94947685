package simgsm.tools;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneNoise;
import simgsm.dtmf.ToneShape;
import simgsm.file.FileErrors;
import simgsm.speech.WavWriter;
import simgsm.tone.ToneLevel;

/** {@code tones KEYS OUT.wav}: DTMF keys as a sound file. */
final class TonesTool {
    private static final int MOST_MILLIS = 60_000;
    private static final int MOST_RAMP_MILLIS = 10;
    private static final double MOST_TWIST = 20;
    private static final double LEAST_NOISE = -20;
    private static final double MOST_NOISE = 60;
    private static final int MOST_SAMPLES = 1 << 29;

    private TonesTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        List<String> rest = arguments.rest();
        if (rest.size() < 2) {
            throw new UsageException(rest.isEmpty() ? "missing KEYS and OUT.wav" : "missing OUT.wav");
        }
        ToneShape level = ToneShape.STANDARD
                .withRamp(0)
                .withMillis((int) arguments.integer("tone-ms", 100, 1, MOST_MILLIS), (int)
                        arguments.integer("pause-ms", 100, 0, MOST_MILLIS))
                .withLevel(arguments.value("level", TonesTool::level).orElse(-10.0))
                .withRamp(ramp(arguments));
        double twist = arguments
                .value("twist", text -> decibels(text, -MOST_TWIST, MOST_TWIST))
                .orElse(0.0);
        ToneShape shape = Arguments.checked(() -> level.withTwist(twist));
        short[] samples = sound(keys(rest.get(0)), shape);
        Optional<Double> noise = arguments.value("noise", text -> decibels(text, LEAST_NOISE, MOST_NOISE));
        if (noise.isPresent()) {
            ToneNoise.add(samples, shape, noise.get(), arguments.integer("seed", 1, Long.MIN_VALUE, Long.MAX_VALUE));
        }
        Path file = Path.of(rest.get(1));
        FileErrors.naming(file, () -> WavWriter.write(file, samples));
        return ExitStatus.OK;
    }

    private static double decibels(String text, double least, double most) {
        if (text.matches("[-+]?[0-9]{1,4}(\\.[0-9]{1,9})?")) {
            double value = Double.parseDouble(text);
            if (value >= least && value <= most) {
                return value;
            }
        }
        throw new IllegalArgumentException("expected " + least + " to " + most + " dB, found " + text);
    }

    /** Milliseconds, at most the tone's length. */
    private static double ramp(Arguments arguments) throws UsageException {
        double millis = arguments.number("ramp", ToneShape.STANDARD.rampMillis(), 0, MOST_RAMP_MILLIS);
        return Math.min(millis, arguments.integer("tone-ms", 100, 1, MOST_MILLIS));
    }

    private static double level(String text) {
        if (text.matches("[-+]?[0-9]{1,4}(\\.[0-9]{1,9})?")) {
            double dbm0 = Double.parseDouble(text);
            if (dbm0 >= -100 && dbm0 <= ToneLevel.FULL_SCALE_DBM0) {
                return dbm0;
            }
        }
        throw new IllegalArgumentException("expected a level of -100 to 3.14 dBm0, found " + text);
    }

    private static List<DtmfKey> keys(String text) throws UsageException {
        try {
            List<DtmfKey> keys = DtmfKey.sequence(text);
            if (!keys.isEmpty()) {
                return keys;
            }
        } catch (IllegalArgumentException e) {
            throw new UsageException("KEYS: " + e.getMessage());
        }
        throw new UsageException("KEYS: no key");
    }

    private static short[] sound(List<DtmfKey> keys, ToneShape shape) throws UsageException {
        long length = 8L * (shape.toneMillis() + shape.pauseMillis()) * keys.size();
        if (length > MOST_SAMPLES) {
            throw new UsageException("KEYS: longer than " + MOST_SAMPLES / 8000 + " s");
        }
        DtmfGenerator generator = new DtmfGenerator(shape, key -> {});
        keys.forEach(generator::enqueue);
        short[] samples = new short[(int) length];
        generator.read(samples);
        return samples;
    }
}
