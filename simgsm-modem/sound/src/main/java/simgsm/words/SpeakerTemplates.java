package simgsm.words;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.words.WordComparison.WordDistance;

/** A speaker's own words, each enrolled several times, and the comparison of a heard one with them. Owned by one thread. */
public final class SpeakerTemplates {
    /** Templates of a word; a further one takes the place of the oldest. */
    public static final int MOST = 4;

    private static final int NEAREST = 2;

    private final Map<String, List<SpokenWord>> templates = new LinkedHashMap<>();

    /** Without templates. */
    public SpeakerTemplates() {}

    public void add(String word, SpokenWord template) {
        List<SpokenWord> own = templates.computeIfAbsent(word, key -> new ArrayList<>());
        if (own.size() == MOST) {
            own.remove(0);
        }
        own.add(template);
    }

    /** The number of a word's templates. */
    public int count(String word) {
        return templates.getOrDefault(word, List.of()).size();
    }

    public Collection<String> words() {
        return templates.keySet();
    }

    /** @param allowed the words to compare with @return empty without templates of them */
    public Optional<HeardWord> hear(SpokenWord heard, Collection<String> allowed) {
        return result(heard, distances(heard, allowed));
    }

    private Optional<HeardWord> result(SpokenWord heard, List<WordDistance> found) {
        if (found.isEmpty()) {
            return Optional.empty();
        }
        WordDistance best = found.get(0);
        WordDistance second = found.size() > 1 ? found.get(1) : new WordDistance("", Double.POSITIVE_INFINITY);
        boolean fits = templates.get(best.word()).stream().anyMatch(each -> TimeWarping.fits(heard, each));
        double ratio = fits ? best.distance() / second.distance() : 1;
        return Optional.of(new HeardWord(best.word(), second.word(), ratio, fits));
    }

    /** As {@link #hear}, with what leads to the result. @param frames of the word, as {@link WordCutter} cuts it */
    public Optional<WordComparison> compare(List<SpeechFrame> frames, Collection<String> allowed) {
        SpokenWord heard = SpokenWord.of(frames);
        List<WordDistance> distances = distances(heard, allowed);
        return result(heard, distances).map(result -> {
            SpokenWord nearest = templates.get(result.word()).stream()
                    .min(Comparator.comparingDouble(template -> TimeWarping.distance(heard, template)))
                    .orElseThrow();
            return new WordComparison(frames, result, distances, TimeWarping.path(heard, nearest));
        });
    }

    private List<WordDistance> distances(SpokenWord heard, Collection<String> allowed) {
        return allowed.stream()
                .map(word -> new WordDistance(word, distance(heard, word)))
                .filter(found -> found.distance() < Double.POSITIVE_INFINITY)
                .sorted(Comparator.comparingDouble(WordDistance::distance))
                .toList();
    }

    /** Mean distance of the word's two nearest templates: a single one may be near by chance. */
    private double distance(SpokenWord heard, String word) {
        return templates.getOrDefault(word, List.of()).stream()
                .mapToDouble(template -> TimeWarping.distance(heard, template))
                .sorted()
                .limit(NEAREST)
                .average()
                .orElse(Double.POSITIVE_INFINITY);
    }
}
