package simgsm.words;

import java.util.List;

/**
 * The comparison of a word with a speaker's templates, for a picture.
 *
 * @param frames of the word, each 10 ms
 * @param result what the ear has decided
 * @param distances of the words that were allowed, the nearest first
 * @param path for each frame of the word the aligned one of the nearest template, as a share of the template, 0 to 1
 */
public record WordComparison(
        List<SpeechFrame> frames, HeardWord result, List<WordDistance> distances, List<Double> path) {
    /** @param distance mean over the aligned frames */
    public record WordDistance(String word, double distance) {}

    public WordComparison {
        frames = List.copyOf(frames);
        distances = List.copyOf(distances);
        path = List.copyOf(path);
    }
}
