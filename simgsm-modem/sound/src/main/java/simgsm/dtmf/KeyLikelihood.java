package simgsm.dtmf;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Log odds that two tones are a key's: a constant and one curve for each of the {@link KeyMeasures}, added. The curves are
 * steps; {@code key-likelihood.txt} holds them as the tests' program {@code LikelihoodFit} fitted them to labelled
 * recordings.
 *
 * <pre>
 *   bias VALUE
 *   KIND unknown VALUE  first VALUE  EDGE VALUE  EDGE VALUE ...     (from EDGE upward VALUE holds)
 * </pre>
 */
final class KeyLikelihood {
    /** Two tones with larger log odds (base e) are a key's. */
    static final double LIMIT = 3.5;

    /** Of an earlier window so much does not count towards the sum. */
    static final double LEAST = 1.5;

    private static final String TABLE = "key-likelihood.txt";
    private static final KeyLikelihood FITTED = read();

    private final double bias;
    private final double[][] edges;
    /** By kind: below the first edge, then from each edge upward. */
    private final double[][] steps;

    private final double[] unknown;
    /** By kind: the most that it can add. */
    private final double[] largest = new double[KeyMeasures.COUNT];

    KeyLikelihood(double bias, double[][] edges, double[][] steps, double[] unknown) {
        this.bias = bias;
        this.edges = edges;
        this.steps = steps;
        this.unknown = unknown;
        for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
            largest[kind] =
                    Math.max(unknown[kind], Arrays.stream(steps[kind]).max().orElseThrow());
        }
    }

    /** The one that the receiver decides with. */
    static KeyLikelihood fitted() {
        return FITTED;
    }

    /** The log odds, or any value up to 0 where they cannot be larger, whatever the spectrum shows. */
    double logOdds(KeyMeasures measures, ToneFit fit, short[] samples, int end) {
        measures.measureTones(fit);
        double most = bias;
        for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
            most += kind < KeyMeasures.OF_TONES ? part(kind, measures.values[kind]) : largest[kind];
        }
        if (most <= 0) {
            return most;
        }
        measures.measureSpectrum(fit, samples, end);
        return logOdds(measures.values);
    }

    double logOdds(double[] values) {
        double sum = bias;
        for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
            sum += part(kind, values[kind]);
        }
        return sum;
    }

    /** What one measure adds. */
    double part(int kind, double value) {
        if (Double.isNaN(value)) {
            return unknown[kind];
        }
        int at = Arrays.binarySearch(edges[kind], value);
        return steps[kind][at >= 0 ? at + 1 : -at - 1];
    }

    /** The measure that speaks loudest against a key. */
    KeyMeasures.Kind mostAgainst(double[] values) {
        int worst = 0;
        for (int kind = 1; kind < KeyMeasures.COUNT; kind++) {
            if (part(kind, values[kind]) < part(worst, values[worst])) {
                worst = kind;
            }
        }
        return KeyMeasures.Kind.values()[worst];
    }

    private static KeyLikelihood read() {
        double bias = 0;
        double[][] edges = new double[KeyMeasures.COUNT][];
        double[][] steps = new double[KeyMeasures.COUNT][];
        double[] unknown = new double[KeyMeasures.COUNT];
        try (InputStream in = KeyLikelihood.class.getResourceAsStream(TABLE);
                BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                String[] words = line.split(" +");
                if (words[0].equals("bias")) {
                    bias = Double.parseDouble(words[1]);
                } else if (!words[0].startsWith("#")) {
                    int kind = KeyMeasures.Kind.valueOf(words[0]).ordinal();
                    int count = (words.length - 5) / 2;
                    unknown[kind] = Double.parseDouble(words[2]);
                    edges[kind] = new double[count];
                    steps[kind] = new double[count + 1];
                    steps[kind][0] = Double.parseDouble(words[4]);
                    for (int i = 0; i < count; i++) {
                        edges[kind][i] = Double.parseDouble(words[5 + 2 * i]);
                        steps[kind][i + 1] = Double.parseDouble(words[6 + 2 * i]);
                    }
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return new KeyLikelihood(bias, edges, steps, unknown);
    }
}
