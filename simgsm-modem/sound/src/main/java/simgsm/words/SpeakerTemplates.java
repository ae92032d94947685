package simgsm.words;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A speaker's own words, each enrolled several times, and the comparison of a heard one with them. Owned by one thread. */
public final class SpeakerTemplates {
    private record Rival(String word, double distance) {}

    private static final int NEAREST = 2;

    private final Map<String, List<SpokenWord>> templates = new LinkedHashMap<>();

    /** Without templates. */
    public SpeakerTemplates() {}

    public void add(String word, SpokenWord template) {
        templates.computeIfAbsent(word, key -> new ArrayList<>()).add(template);
    }

    /** The number of a word's templates. */
    public int count(String word) {
        return templates.getOrDefault(word, List.of()).size();
    }

    public Collection<String> words() {
        return templates.keySet();
    }

    /** @param allowed the words to compare with @return empty if none of them can be aligned */
    public Optional<HeardWord> hear(SpokenWord heard, Collection<String> allowed) {
        List<Rival> rivals = allowed.stream()
                .map(word -> new Rival(word, distance(heard, word)))
                .filter(rival -> rival.distance() < Double.POSITIVE_INFINITY)
                .sorted(Comparator.comparingDouble(Rival::distance))
                .toList();
        if (rivals.isEmpty()) {
            return Optional.empty();
        }
        Rival best = rivals.get(0);
        Rival second = rivals.size() > 1 ? rivals.get(1) : new Rival("", Double.POSITIVE_INFINITY);
        return Optional.of(new HeardWord(best.word(), second.word(), best.distance() / second.distance()));
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
