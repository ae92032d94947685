package simgsm.words;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * Finds words in frames by their energy: a word begins after 50 ms above the threshold and has ended after 300 ms below
 * it, or lasts 2 s; then {@link #cut} finds its ends. Owned by one thread.
 */
public final class WordCutter {
    private static final int BEGIN_FRAMES = 5;
    private static final int END_FRAMES = 30;
    private static final int MOST_FRAMES = 200;
    /** Frames before the beginning that are kept for {@link #cut}. */
    private static final int LEAD_FRAMES = 25;
    /** The noise is the median over as many frames at both ends. */
    private static final int NOISE_FRAMES = 12;
    /** The shortest word, 80 ms. */
    private static final int LEAST_FRAMES = 8;
    /** Longest gap within a word. */
    private static final int GAP_FRAMES = 20;

    private static final int MARGIN_FRAMES = 3;
    private static final double ABOVE_NOISE_DB = 5;
    private static final double MOST_OF_RANGE = 0.35;
    private static final double BELOW_PEAK_DB = 40;
    private static final double LIVE_ABOVE_NOISE_DB = 10;
    /** Quieter sound is no speech: 30 of 32 768 on average. */
    private static final double LEAST_DB = 30;

    private final Consumer<List<SpeechFrame>> words;
    private final Deque<SpeechFrame> recent = new ArrayDeque<>();
    private final List<SpeechFrame> word = new ArrayList<>();
    private int above;
    private int below;

    /** @param words receives the frames of each word after its end */
    public WordCutter(Consumer<List<SpeechFrame>> words) {
        this.words = words;
    }

    /** Forgets what was heard so far. */
    public void reset() {
        recent.clear();
        word.clear();
        above = 0;
        below = 0;
    }

    /** True while a word lasts. */
    public boolean isInWord() {
        return !word.isEmpty();
    }

    public void accept(SpeechFrame frame) {
        boolean isLoud = frame.energyDb() > threshold();
        if (word.isEmpty()) {
            recent.addLast(frame);
            if (recent.size() > LEAD_FRAMES) {
                recent.removeFirst();
            }
            above = isLoud ? above + 1 : 0;
            if (above == BEGIN_FRAMES) {
                word.addAll(recent);
                below = 0;
            }
            return;
        }
        word.add(frame);
        below = isLoud ? 0 : below + 1;
        if (below == END_FRAMES || word.size() == MOST_FRAMES + LEAD_FRAMES) {
            Optional<List<SpeechFrame>> cut = cut(word);
            reset();
            cut.ifPresent(words);
        }
    }

    /** Above the median of the first frames kept, which come before the word. */
    private double threshold() {
        double[] quiet = (word.isEmpty() ? recent : word)
                .stream()
                        .limit(NOISE_FRAMES)
                        .mapToDouble(SpeechFrame::energyDb)
                        .sorted()
                        .toArray();
        double noise = quiet.length == 0 ? LEAST_DB : quiet[quiet.length / 2];
        return Math.max(LEAST_DB, noise + LIVE_ABOVE_NOISE_DB);
    }

    /** The loudest word in the frames, with 30 ms around it; empty if there is none. */
    public static Optional<List<SpeechFrame>> cut(List<SpeechFrame> frames) {
        double[] energies = frames.stream().mapToDouble(SpeechFrame::energyDb).toArray();
        double peak = Arrays.stream(energies).max().orElse(0);
        double noise = noise(energies);
        double threshold =
                Math.max(noise + Math.min(ABOVE_NOISE_DB, MOST_OF_RANGE * (peak - noise)), peak - BELOW_PEAK_DB);
        int from = 0;
        int to = 0;
        double best = 0;
        for (int i = 0; i < energies.length; i++) {
            int begin = i;
            int end = i;
            double sum = 0;
            for (; i < energies.length && i - end <= GAP_FRAMES && energies[begin] > threshold; i++) {
                if (energies[i] > threshold) {
                    end = i;
                    sum += energies[i] - threshold;
                }
            }
            if (sum > best) {
                best = sum;
                from = begin;
                to = end + 1;
            }
        }
        return to - from < LEAST_FRAMES || peak < LEAST_DB
                ? Optional.empty()
                : Optional.of(List.copyOf(frames.subList(
                        Math.max(0, from - MARGIN_FRAMES), Math.min(energies.length, to + MARGIN_FRAMES))));
    }

    /** Median of the first and the last frames. */
    private static double noise(double[] energies) {
        int ends = Math.min(NOISE_FRAMES, energies.length / 2);
        double[] noises = IntStream.range(0, energies.length)
                .filter(i -> i < ends || i >= energies.length - ends)
                .mapToDouble(i -> energies[i])
                .sorted()
                .toArray();
        return noises.length == 0 ? 0 : noises[noises.length / 2];
    }
}
