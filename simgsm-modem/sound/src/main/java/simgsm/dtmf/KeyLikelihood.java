package simgsm.dtmf;

import java.util.Arrays;
import java.util.Locale;
import java.util.ResourceBundle;

/**
 * Log odds that two tones are a key's: the sum of a constant and one step curve for each of the {@link KeyMeasures}.
 * The table {@code key-likelihood.properties} was fitted to labelled recordings by {@code LikelihoodFit}, a test
 * program.
 */
final class KeyLikelihood {
    /** Subtracted from the log odds of an earlier window before they are added. */
    static final double LEAST = 1.5;

    private static final KeyLikelihood FITTED = read();

    private final double bias;
    private final double[][] edges;
    /** By kind: below the first edge, then from each edge upward. */
    private final double[][] steps;

    private final double[] unknown;
    /** Largest addend, by kind. */
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

    /** The receiver's likelihood. */
    static KeyLikelihood fitted() {
        return FITTED;
    }

    /** The log odds; any value up to 0 if they cannot be larger for any spectrum. */
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

    /** Addend of one measure. */
    double part(int kind, double value) {
        if (Double.isNaN(value)) {
            return unknown[kind];
        }
        int at = Arrays.binarySearch(edges[kind], value);
        return steps[kind][at >= 0 ? at + 1 : -at - 1];
    }

    /** The measure with the strongest evidence against a key. */
    KeyMeasures.Kind mostAgainst(KeyMeasures measures) {
        double[] values = measures.values;
        int worst = 0;
        for (int kind = 1; kind < measures.known; kind++) {
            if (part(kind, values[kind]) < part(worst, values[worst])) {
                worst = kind;
            }
        }
        return KeyMeasures.Kind.values()[worst];
    }

    private static KeyLikelihood read() {
        ResourceBundle table = ResourceBundle.getBundle("simgsm.dtmf.key-likelihood", Locale.ROOT);
        double[][] edges = new double[KeyMeasures.COUNT][];
        double[][] steps = new double[KeyMeasures.COUNT][];
        double[] unknown = new double[KeyMeasures.COUNT];
        for (KeyMeasures.Kind kind : KeyMeasures.Kind.values()) {
            double[] numbers = Arrays.stream(table.getString(kind.name()).split(" +"))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            int count = numbers.length / 2 - 1;
            unknown[kind.ordinal()] = numbers[0];
            edges[kind.ordinal()] = new double[count];
            steps[kind.ordinal()] = new double[count + 1];
            steps[kind.ordinal()][0] = numbers[1];
            for (int i = 0; i < count; i++) {
                edges[kind.ordinal()][i] = numbers[2 + 2 * i];
                steps[kind.ordinal()][i + 1] = numbers[3 + 2 * i];
            }
        }
        return new KeyLikelihood(Double.parseDouble(table.getString("BIAS")), edges, steps, unknown);
    }
}
