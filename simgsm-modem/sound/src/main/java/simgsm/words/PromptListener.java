package simgsm.words;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Reads the built-in prompts of both languages from the speech of a call, for a caption. A modem sends them in whole
 * frames, so each received frame of 160 samples is compared with each frame of each prompt; the cheapest series of prompts
 * and of other sound is the sentence (dynamic programming). Owned by one thread; takes 0.3 % of a core.
 */
public final class PromptListener {
    private static final int SAMPLES = 160;
    /** Highest cost of a frame that belongs to no prompt, in nepers averaged over the bands; silence costs less. */
    static final double OTHER = 0.55;
    /** Magnitudes below this are equal: the noise of the codecs. */
    private static final double FLOOR = 300;
    /** Frames without a prompt that end a sentence, 300 ms. */
    private static final int END_FRAMES = 15;

    private static final double SILENCE = 0.02;
    private static final float[] SILENT = new float[MelSpectrum.BANDS];

    static {
        Arrays.fill(SILENT, (float) Math.log(FLOOR));
    }

    record Pattern(String name, float[][] frames) {}

    private record Path(Path before, String name) {
        static final Path NONE = new Path(null, "");
    }

    /** The patterns of all prompts, made by a thread of their own: they take 0.5 s and would hold up a call's thread. */
    private static final class Patterns {
        static final CompletableFuture<List<Pattern>> MADE =
                CompletableFuture.supplyAsync(PromptListener::patterns, task -> {
                    Thread thread = new Thread(task, "prompts");
                    thread.setDaemon(true);
                    thread.setPriority(Thread.MIN_PRIORITY);
                    thread.start();
                });
    }

    private final Consumer<Utterance> sentences;
    private final double[] window = new double[MelSpectrum.FRAME + 1];
    private double[][] costs;
    private Path[][] paths;
    private double endCost;
    private Path end = Path.NONE;
    private int otherFrames;

    /** @param sentences receives each sentence 300 ms after its end */
    public PromptListener(Consumer<Utterance> sentences) {
        this.sentences = sentences;
    }

    /** Waits until sentences are read; without it the first second of a process's first call has no caption. */
    public static void load() {
        Patterns.MADE.join();
    }

    private static List<Pattern> patterns() {
        return Stream.of(SpokenLanguage.values())
                .map(Prompts::of)
                .flatMap(prompts -> prompts.names().stream().map(name -> pattern(prompts, name)))
                .toList();
    }

    private static Pattern pattern(Prompts prompts, String name) {
        return new Pattern(name, bands(prompts.samples(new Utterance(List.of(name)))));
    }

    private static float[][] bands(short[] samples) {
        double[] window = new double[MelSpectrum.FRAME + 1];
        float[][] bands = new float[samples.length / SAMPLES][];
        for (int i = 0; i < bands.length; i++) {
            bands[i] = bands(samples, i * SAMPLES, window);
        }
        return bands;
    }

    private static float[] bands(short[] samples, int from, double[] window) {
        for (int i = 0; i < SAMPLES; i++) {
            window[i + 1] = samples[from + i];
        }
        float[] bands = MelSpectrum.of(window);
        for (int k = 0; k < bands.length; k++) {
            bands[k] = (float) Math.log(Math.max(FLOOR, bands[k]));
        }
        return bands;
    }

    /** A call has begun. */
    public void reset() {
        if (costs != null) {
            for (double[] row : costs) {
                Arrays.fill(row, Double.POSITIVE_INFINITY);
            }
        }
        endCost = 0;
        end = Path.NONE;
        otherFrames = 0;
    }

    /** @param frame 160 samples */
    public void accept(short[] frame) {
        List<Pattern> known = Patterns.MADE.getNow(List.of());
        if (known.isEmpty()) {
            return;
        }
        if (costs == null) {
            costs = new double[known.size()][];
            paths = new Path[known.size()][];
            for (int p = 0; p < costs.length; p++) {
                costs[p] = new double[known.get(p).frames().length];
                paths[p] = new Path[costs[p].length];
            }
            reset();
        }
        float[] heard = bands(frame, 0, window);
        double best = endCost + Math.min(OTHER, SILENCE + distance(SILENT, heard));
        Path path = end;
        double inside = Double.POSITIVE_INFINITY;
        for (int p = 0; p < costs.length; p++) {
            Pattern pattern = known.get(p);
            advance(p, pattern.frames(), heard);
            int last = costs[p].length - 1;
            for (int i = 0; i < last; i++) {
                inside = Math.min(inside, costs[p][i]);
            }
            if (costs[p][last] < best) {
                best = costs[p][last];
                path = new Path(paths[p][last], pattern.name());
            }
        }
        otherFrames = path == end ? otherFrames + 1 : 0;
        end = path;
        endCost = best;
        if (otherFrames >= END_FRAMES && inside > endCost) {
            settle();
        }
    }

    /** Ends the paths that cannot win: to the last frame of the prompt, other sound costs at most OTHER a frame. */
    private void advance(int p, float[][] frames, float[] heard) {
        for (int i = frames.length - 1; i >= 0; i--) {
            double before = i == 0 ? endCost : costs[p][i - 1];
            if (before == Double.POSITIVE_INFINITY) {
                costs[p][i] = before;
                continue;
            }
            double cost = before + distance(frames[i], heard);
            boolean canWin = cost < endCost + OTHER * (frames.length - i);
            costs[p][i] = canWin ? cost : Double.POSITIVE_INFINITY;
            paths[p][i] = i == 0 ? end : paths[p][i - 1];
        }
    }

    private static double distance(float[] one, float[] other) {
        double sum = 0;
        for (int k = 0; k < one.length; k++) {
            sum += Math.abs(one[k] - other[k]);
        }
        return sum / one.length;
    }

    private void settle() {
        List<String> names = new ArrayList<>();
        for (Path at = end; at != Path.NONE; at = at.before()) {
            names.add(0, at.name());
        }
        reset();
        if (!names.isEmpty()) {
            sentences.accept(new Utterance(names));
        }
    }
}
