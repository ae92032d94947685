package simgsm.dtmf;

import java.io.PrintWriter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/**
 * Fits the curves of {@link KeyLikelihood} to labelled recordings: additive logistic regression by boosting, one step of one
 * curve at a time. Arguments: the table to write, the seed of the synthetic recordings, and files of speech and music
 * without keys (raw, 8 kHz, 16 bit, little-endian). docs/MEASURED.md says which files were used. {@code -Dskip=KIND} leaves one
 * measure out, to see what it carries.
 */
final class LikelihoodFit {
    private static final int ROUNDS = 1000;
    private static final double RATE = 0.1;
    private static final double REGULARISATION = 1;
    private static final int LEAST_LOOKS = 30;
    private static final int BINS = 24;
    /** Weight of a look that is no key's; a missed look of a key weighs 1, because another look follows. */
    private static final double WEIGHT_OF_OTHERS = 3;

    private final int count;
    private final boolean[] isKey;
    /** By kind: the bin of each look; 0 for unknown. */
    private final byte[][] bins = new byte[KeyMeasures.COUNT][];

    private final double[][] edges = new double[KeyMeasures.COUNT][];
    private final double[][] curves = new double[KeyMeasures.COUNT][];
    private final double[] score;
    private double bias;

    private LikelihoodFit(LabelledLooks looks) {
        count = looks.count();
        isKey = new boolean[count];
        score = new double[count];
        for (int i = 0; i < count; i++) {
            isKey[i] = looks.isKey(i);
        }
        for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
            float[] column = new float[count];
            for (int i = 0; i < count; i++) {
                column[i] = KeyMeasures.Kind.values()[kind].name().equals(System.getProperty("skip"))
                        ? 0
                        : looks.value(i, kind);
            }
            edges[kind] = edges(column, isKey);
            curves[kind] = new double[edges[kind].length + 2];
            bins[kind] = new byte[count];
            for (int i = 0; i < count; i++) {
                int at = Arrays.binarySearch(edges[kind], column[i]);
                bins[kind][i] = (byte) (Float.isNaN(column[i]) ? 0 : 1 + (at >= 0 ? at + 1 : -at - 1));
            }
        }
    }

    /** Quantiles of the keys' values and of the others', so that the curves are fine where both meet. */
    private static double[] edges(float[] column, boolean[] isKey) {
        double[] all = new double[BINS];
        for (int side = 0; side < 2; side++) {
            boolean wanted = side == 0;
            float[] known = new float[column.length];
            int n = 0;
            for (int i = 0; i < column.length; i++) {
                if (isKey[i] == wanted && !Float.isNaN(column[i])) {
                    known[n++] = column[i];
                }
            }
            Arrays.sort(known, 0, n);
            for (int i = 0; i < BINS / 2; i++) {
                all[side * BINS / 2 + i] = round(known[(int) ((i + 0.5) * n / (BINS / 2))]);
            }
        }
        return Arrays.stream(all).sorted().distinct().toArray();
    }

    private static double round(double value) {
        return Double.parseDouble(String.format(Locale.ROOT, "%.4g", value));
    }

    private void fit() {
        long keys = 0;
        for (boolean key : isKey) {
            keys += key ? 1 : 0;
        }
        bias = Math.log(keys / (WEIGHT_OF_OTHERS * (count - keys)));
        Arrays.fill(score, bias);
        double[] gradient = new double[count];
        double[] curvature = new double[count];
        for (int round = 0; round < ROUNDS; round++) {
            for (int i = 0; i < count; i++) {
                double p = 1 / (1 + Math.exp(-score[i]));
                double weight = isKey[i] ? 1 : WEIGHT_OF_OTHERS;
                gradient[i] = weight * (p - (isKey[i] ? 1 : 0));
                curvature[i] = weight * p * (1 - p);
            }
            step(gradient, curvature);
        }
    }

    /** The one step, in one curve, that helps most. */
    private void step(double[] gradient, double[] curvature) {
        int bestKind = -1;
        int bestBin = 0;
        double best = 0;
        double below = 0;
        double above = 0;
        for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
            int n = curves[kind].length;
            double[] g = new double[n];
            double[] h = new double[n];
            int[] looks = new int[n];
            byte[] bin = bins[kind];
            for (int i = 0; i < count; i++) {
                g[bin[i]] += gradient[i];
                h[bin[i]] += curvature[i];
                looks[bin[i]]++;
            }
            double allG = Arrays.stream(g).sum();
            double allH = Arrays.stream(h).sum();
            double leftG = 0;
            double leftH = 0;
            int leftLooks = 0;
            for (int b = 0; b < n - 1; b++) {
                leftG += g[b];
                leftH += h[b];
                leftLooks += looks[b];
                double gain = gain(leftG, leftH) + gain(allG - leftG, allH - leftH);
                if (leftLooks >= LEAST_LOOKS && count - leftLooks >= LEAST_LOOKS && gain > best) {
                    best = gain;
                    bestKind = kind;
                    bestBin = b;
                    below = -RATE * leftG / (leftH + REGULARISATION);
                    above = -RATE * (allG - leftG) / (allH - leftH + REGULARISATION);
                }
            }
        }
        for (int b = 0; b < curves[bestKind].length; b++) {
            curves[bestKind][b] += b <= bestBin ? below : above;
        }
        for (int i = 0; i < count; i++) {
            score[i] += bins[bestKind][i] <= bestBin ? below : above;
        }
    }

    /** What is left to explain: the less the better. */
    private double loss() {
        double loss = 0;
        for (int i = 0; i < count; i++) {
            loss += isKey[i] ? Math.log1p(Math.exp(-score[i])) : WEIGHT_OF_OTHERS * Math.log1p(Math.exp(score[i]));
        }
        return loss;
    }

    private static double gain(double g, double h) {
        return g * g / (h + REGULARISATION);
    }

    private void write(Path table) throws Exception {
        try (PrintWriter out = new PrintWriter(table.toFile(), "US-ASCII")) {
            out.println(
                    "# Log odds of a key by measure (KeyMeasures.Kind), written by LikelihoodFit: value if unknown; value"
                            + " below the first edge;");
            out.println("# then pairs of an edge and the value from that edge upward.");
            out.printf(Locale.ROOT, "BIAS = %.3f%n", bias);
            for (int kind = 0; kind < KeyMeasures.COUNT; kind++) {
                double[] curve = curves[kind];
                out.printf(Locale.ROOT, "%s = %.3f %.3f", KeyMeasures.Kind.values()[kind], curve[0], curve[1]);
                for (int i = 0; i < edges[kind].length; i++) {
                    if (curve[i + 2] != curve[i + 1]) {
                        out.printf(Locale.ROOT, " %s %.3f", Double.toString(edges[kind][i]), curve[i + 2]);
                    }
                }
                out.println();
            }
        }
    }

    static short[] read(String file) throws Exception {
        byte[] octets = Files.readAllBytes(Path.of(file));
        short[] samples = new short[octets.length / 2];
        ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(samples);
        return samples;
    }

    public static void main(String[] args) throws Exception {
        LabelledLooks looks = new LabelledLooks();
        long seed = Long.parseLong(args[1]);
        DisturbedTapes.all(seed, 24, (name, tape) -> looks.collect(tape));
        for (Catalogue.Kind kind : Catalogue.kinds()) {
            Catalogue.tapes(kind, 16, seed).forEach(looks::collect);
        }
        for (int i = 2; i < args.length; i++) {
            short[] speech = read(args[i]);
            looks.collect(speech);
            DisturbedTapes.over(seed + i, 4, speech, (name, tape) -> looks.collect(tape));
        }
        LikelihoodFit fit = new LikelihoodFit(looks);
        fit.fit();
        System.out.printf("%d looks, loss %.0f%n", looks.count(), fit.loss());
        fit.write(Path.of(args[0]));
    }
}
