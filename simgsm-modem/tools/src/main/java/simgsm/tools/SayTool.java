package simgsm.tools;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.file.FileErrors;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;
import simgsm.speech.WavWriter;
import simgsm.tone.Recoder;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;
import simgsm.words.Utterance;

/** {@code say DIR WORD...}: the words of the prompts as sound files, with noise, at another pitch, through a codec. */
final class SayTool {
    private static final int SILENCE_SAMPLES = 2400;
    private static final double MOST_PITCH_PERCENT = 50;
    private static final double MOST_SNR_DECIBELS = 60;
    private static final double LOUD_SHARE = 0.001;

    private SayTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        List<String> rest = arguments.rest();
        if (rest.size() < 2) {
            throw new UsageException("missing " + (rest.isEmpty() ? "DIR" : "WORD"));
        }
        double snr = arguments.number("noise", MOST_SNR_DECIBELS, 0, MOST_SNR_DECIBELS);
        double pitch = arguments.number("pitch", 0, -MOST_PITCH_PERCENT, MOST_PITCH_PERCENT);
        SpeechCodec.Kind codec =
                arguments.value("codec", SpeechCodec.Kind::named).orElse(SpeechCodec.Kind.A_LAW);
        Random random = new Random(arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE));
        Path folder = Path.of(rest.get(0));
        for (String word : rest.subList(1, rest.size())) {
            short[] spoken = pitched(prompt(word), pitch);
            Path file = folder.resolve(word.replace(' ', '-') + ".wav");
            Recoder recoder = new Recoder();
            recoder.set(Optional.of(codec));
            FileErrors.naming(file, () -> write(file, recoder.recoded(noisy(spoken, snr, random))));
            out.println(file);
        }
        return ExitStatus.OK;
    }

    /** A word that is in both languages is said in English. */
    private static short[] prompt(String word) throws UsageException {
        for (SpokenLanguage language : SpokenLanguage.values()) {
            Prompts prompts = Prompts.of(language);
            if (prompts.names().contains(word)) {
                return prompts.samples(new Utterance(List.of(word)));
            }
        }
        throw new UsageException("expected a word of the prompts, such as forward or adelante, found " + word);
    }

    private static Path write(Path file, short[] samples) throws IOException {
        Files.createDirectories(file.toAbsolutePath().getParent());
        try (WavWriter wav = new WavWriter(file, 1)) {
            wav.write(samples);
        }
        return file;
    }

    /** The voice of a shorter or longer vocal tract: all frequencies and the tempo change. */
    private static short[] pitched(short[] samples, double percent) {
        int rate = SpeechCodec.SAMPLES_PER_SECOND;
        int target = (int) Math.round(rate / (1 + percent / 100));
        Resampler resampler = new Resampler(rate, target, Resampler.Slope.STEEP);
        float[] in = new float[samples.length];
        for (int i = 0; i < in.length; i++) {
            in[i] = samples[i];
        }
        resampler.write(in, in.length);
        resampler.end();
        short[] out = new short[(int) ((long) samples.length * target / rate)];
        resampler.read(out, 0, out.length);
        return out;
    }

    /** With 0.3 s before and behind, and white noise below the power of the word's loud samples. */
    private static short[] noisy(short[] spoken, double snrDecibels, Random random) {
        double[] powers = IntStream.range(0, spoken.length)
                .mapToDouble(i -> (double) spoken[i] * spoken[i])
                .toArray();
        double limit = LOUD_SHARE * Arrays.stream(powers).max().orElse(0);
        double loud =
                Arrays.stream(powers).filter(power -> power > limit).average().orElse(0);
        double sigma = Math.sqrt(loud * Math.pow(10, -snrDecibels / 10));
        int frames = (spoken.length + 2 * SILENCE_SAMPLES) / SpeechCodec.SAMPLES_PER_FRAME + 1;
        short[] noisy = new short[frames * SpeechCodec.SAMPLES_PER_FRAME];
        for (int i = 0; i < noisy.length; i++) {
            int at = i - SILENCE_SAMPLES;
            double sample = at >= 0 && at < spoken.length ? spoken[at] : 0;
            noisy[i] = Resampler.saturate((float) (sample + sigma * random.nextGaussian()));
        }
        return noisy;
    }
}
