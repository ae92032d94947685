package blackbox.uml;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** The few arrows that a picture needs. */
final class Arrows {
    private Arrows() {}

    /** Without the arrows that a way over other arrows implies. */
    static Map<String, Set<String>> reduced(Map<String, Set<String>> arrows) {
        Map<String, Set<String>> few = new TreeMap<>();
        arrows.forEach((from, targets) -> {
            Set<String> direct = new TreeSet<>(targets);
            direct.removeIf(to -> targets.stream()
                    .anyMatch(over -> !over.equals(to) && reaches(arrows, over, to, new HashSet<>(Set.of(from)))));
            few.put(from, direct);
        });
        return few;
    }

    private static boolean reaches(Map<String, Set<String>> arrows, String from, String to, Set<String> seen) {
        if (!seen.add(from)) {
            return false;
        }
        Set<String> next = arrows.getOrDefault(from, Set.of());
        return next.contains(to) || next.stream().anyMatch(over -> reaches(arrows, over, to, seen));
    }
}
