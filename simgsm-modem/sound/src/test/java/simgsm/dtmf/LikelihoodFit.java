package simgsm.dtmf;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.TreeSet;

/**
 * Fits the addends of {@link KeyMeasures} to labelled recordings: logistic regression on the best look of each event, since a key
 * is heard, and other sound taken for one, if any look is above the limit. The best looks of one round are the next one's
 * material. Arguments: the seed of the synthetic recordings, and files of speech and music without keys (raw, 8 kHz, 16 bit,
 * little-endian), the first of them also under keys. docs/MEASURED.md says which files were used. Prints the curves.
 */
final class LikelihoodFit {
    private static final int ROUNDS = 7;
    private static final int ITERATIONS = 30;
    private static final double REGULARISATION = 0.3;
    /** Other sound with less does not matter. */
    private static final double HOPELESS = -9;
    /**
     * Log odds of the fit at which the receiver's limit stands: the lowest that takes no key from 1.4 hours of human voices as
     * they are and in eleven treatments.
     */
    private static final double AT_LIMIT = 1.4;

    private final LabelledLooks looks;
    private final int[] first = new int[KeyMeasures.COUNT];
    private final double[] feature;
    /** The constant, and by kind one addend for each value of the curve. */
    private double[] addend;

    private LikelihoodFit(LabelledLooks looks) {
        this.looks = looks;
        int size = 1;
        for (KeyMeasures.Kind kind : KeyMeasures.Kind.values()) {
            first[kind.ordinal()] = size;
            size += kind.curve.length / 2;
        }
        feature = new double[size];
        addend = new double[size];
    }

    /** The share of each addend in a look's log odds. */
    private void measure(int look) {
        Arrays.fill(feature, 0);
        feature[0] = 1;
        for (KeyMeasures.Kind kind : KeyMeasures.Kind.values()) {
            double[] curve = kind.curve;
            double value = looks.value(look, kind.ordinal());
            int at = 0;
            while (at + 4 < curve.length && curve[at + 2] < value) {
                at += 2;
            }
            double share = Math.max(0, Math.min(1, (value - curve[at]) / (curve[at + 2] - curve[at])));
            feature[first[kind.ordinal()] + at / 2] = 1 - share;
            feature[first[kind.ordinal()] + at / 2 + 1] = share;
        }
    }

    private double logOdds(int look, double[] addends) {
        measure(look);
        double sum = 0;
        for (int i = 0; i < feature.length; i++) {
            sum += feature[i] * addends[i];
        }
        return sum;
    }

    private void fit() {
        int[] some = new int[looks.count() / 5];
        Arrays.setAll(some, i -> 5 * i);
        regress(some);
        TreeSet<Integer> others = new TreeSet<>();
        for (int round = 0; round < ROUNDS; round++) {
            TreeSet<Integer> material = new TreeSet<>();
            for (int from = 0, to; from < looks.count(); from = to) {
                int best = from;
                double most = Double.NEGATIVE_INFINITY;
                for (to = from; to < looks.count() && looks.event(to) == looks.event(from); to++) {
                    double odds = logOdds(to, addend);
                    best = odds > most ? to : best;
                    most = Math.max(most, odds);
                }
                (looks.isKey(best) ? material : others).add(best);
            }
            others.removeIf(look -> logOdds(look, addend) < HOPELESS);
            material.addAll(others);
            regress(material.stream().mapToInt(look -> look).toArray());
        }
    }

    /** Newton's method with halved steps. */
    private void regress(int[] material) {
        int n = addend.length;
        double loss = loss(material, addend);
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            double[][] rows = new double[n][n + 1];
            for (int i = 0; i < n; i++) {
                rows[i][i] = REGULARISATION;
                rows[i][n] = REGULARISATION * addend[i];
            }
            for (int look : material) {
                double p = 1 / (1 + Math.exp(-logOdds(look, addend)));
                double gradient = looks.weight(look) * (p - (looks.isKey(look) ? 1 : 0));
                double curvature = looks.weight(look) * p * (1 - p);
                for (int i = 0; i < n; i++) {
                    if (feature[i] != 0) {
                        for (int j = 0; j < n; j++) {
                            rows[i][j] += curvature * feature[i] * feature[j];
                        }
                        rows[i][n] += gradient * feature[i];
                    }
                }
            }
            double[] step = solve(rows);
            double next;
            double[] tried = new double[n];
            double length = 1;
            do {
                double part = length;
                Arrays.setAll(tried, i -> addend[i] - part * step[i]);
                next = loss(material, tried);
                length /= 2;
            } while (next > loss && length > 1e-3);
            addend = tried;
            if (loss - next < 1e-4 * loss) {
                return;
            }
            loss = next;
        }
    }

    private double loss(int[] material, double[] addends) {
        double loss =
                REGULARISATION / 2 * Arrays.stream(addends).map(x -> x * x).sum();
        for (int look : material) {
            double odds = logOdds(look, addends);
            loss += looks.weight(look) * Math.log1p(Math.exp(looks.isKey(look) ? -odds : odds));
        }
        return loss;
    }

    /** Gaussian elimination of a positive definite matrix with its right side. */
    private static double[] solve(double[][] rows) {
        int n = rows.length;
        for (int k = 0; k < n; k++) {
            for (int i = k + 1; i < n; i++) {
                double factor = rows[i][k] / rows[k][k];
                for (int j = k; j <= n; j++) {
                    rows[i][j] -= factor * rows[k][j];
                }
            }
        }
        double[] x = new double[n];
        for (int i = n - 1; i >= 0; i--) {
            x[i] = rows[i][n];
            for (int j = i + 1; j < n; j++) {
                x[i] -= rows[i][j] * x[j];
            }
            x[i] /= rows[i][i];
        }
        return x;
    }

    private void print() {
        double bias = addend[0] + DtmfReceiver.LIMIT - AT_LIMIT;
        for (KeyMeasures.Kind kind : KeyMeasures.Kind.values()) {
            int at = first[kind.ordinal()];
            int n = kind.curve.length / 2;
            double most = Arrays.stream(addend, at, at + n).max().orElseThrow();
            bias += most;
            System.out.print(kind);
            for (int i = 0; i < n; i++) {
                System.out.printf(
                        Locale.ROOT, "%s%s, %.2f", i == 0 ? "(" : ", ", kind.curve[2 * i], addend[at + i] - most);
            }
            System.out.println(")");
        }
        System.out.printf(Locale.ROOT, "BIAS = %.2f; %d looks%n", bias, looks.count());
    }

    static short[] read(String file) throws Exception {
        byte[] octets = Files.readAllBytes(Path.of(file));
        short[] samples = new short[octets.length / 2];
        ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(samples);
        return samples;
    }

    public static void main(String[] args) throws Exception {
        LabelledLooks looks = new LabelledLooks();
        long seed = Long.parseLong(args[0]);
        DisturbedTapes.all(seed, 12, (name, tape) -> looks.collect(tape, 2));
        for (Catalogue.Kind kind : Catalogue.kinds()) {
            double weight = kind.grade() == Catalogue.Grade.SILENT ? 8 : kind.grade() == Catalogue.Grade.HARDER ? 1 : 3;
            Catalogue.tapes(kind, 8, seed).forEach(tape -> looks.collect(tape, weight));
        }
        for (int i = 1; i < args.length; i++) {
            short[] speech = read(args[i]);
            VoiceTapes.treated(speech).values().forEach(sound -> looks.collect(sound, 3));
            DisturbedTapes.over(seed + i, 2, speech, (name, tape) -> looks.collect(tape, 2));
        }
        LineTapes.all(seed, 4 * LineTapes.RECORDINGS, read(args[1]), (name, tape) -> looks.collect(tape, 3));
        for (int hertz = 85; hertz <= 260; hertz += 3) {
            VoiceTapes.treated(VoiceTapes.vowels(hertz, seed)).values().forEach(sound -> looks.collect(sound, 3));
        }
        LikelihoodFit fit = new LikelihoodFit(looks);
        fit.fit();
        fit.print();
    }
}
