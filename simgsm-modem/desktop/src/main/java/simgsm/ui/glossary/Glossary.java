package simgsm.ui.glossary;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The terms of GSM, tones and the robot, each explained in a sentence or two. */
public final class Glossary {
    private final Map<String, String> explanations;
    private final Map<String, String> terms = new LinkedHashMap<>();
    private final Pattern pattern;

    /** A part of a text. @param term named by it; empty for none */
    public record Part(String text, String term) {
        public static Part plain(String text) {
            return new Part(text, "");
        }
    }

    /** @param lines {@code TERM / OTHER NAME: explanation}, each */
    private Glossary(List<String> lines) {
        Map<String, String> read = new LinkedHashMap<>();
        for (String line : lines) {
            String[] entry = line.split("\\s*:\\s*", 2);
            String[] names = entry[0].split("\\s*/\\s*");
            for (String name : names) {
                terms.put(name.toLowerCase(Locale.ROOT), names[0]);
            }
            read.put(names[0], entry[1]);
        }
        explanations = read;
        pattern = Pattern.compile(
                "(?<![\\p{L}\\p{N}-])("
                        + terms.keySet().stream()
                                .sorted(Comparator.comparingInt(String::length).reversed())
                                .map(Pattern::quote)
                                .collect(Collectors.joining("|"))
                        + ")(?:e?s)?(?![\\p{L}\\p{N}-])",
                Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE);
    }

    public static Glossary in(Locale language) {
        String file = language.getLanguage().equals("es") ? "es.txt" : "en.txt";
        try (InputStream in = Glossary.class.getResourceAsStream(file)) {
            return new Glossary(new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public Set<String> terms() {
        return explanations.keySet();
    }

    /** The explanation of a term by any of its names, ignoring case. */
    public Optional<String> find(String name) {
        return Optional.ofNullable(terms.get(name.strip().toLowerCase(Locale.ROOT)))
                .map(explanations::get);
    }

    /**
     * The explanation of a GSM message by its name; of the outer one in "CP-DATA (RP-DATA SUBMIT)". Message names
     * that are everyday words, such as Hold, are not linked in texts.
     */
    public Optional<String> findMessage(String name) {
        String outer = outer(name);
        return find("message " + outer).or(() -> find(outer)).map(text -> outer + ": " + text);
    }

    /** The explanation of a carried message, {@code SUBMIT} in "CP-DATA (RP-DATA SUBMIT)"; empty for none. */
    public Optional<String> findCarried(String name) {
        String[] carried = name.substring(outer(name).length())
                .replaceAll("[()]", " ")
                .strip()
                .split(" ");
        return findMessage(carried[carried.length - 1]);
    }

    private static String outer(String name) {
        return name.replaceFirst(" \\(.*", "");
    }

    public boolean hasTerms(String text) {
        return parts(text).stream().anyMatch(part -> !part.term().isEmpty());
    }

    /** Splits a text so that the first occurrence of each term, also in the plural, is its own part. */
    public List<Part> parts(String text) {
        List<Part> parts = new ArrayList<>();
        List<String> seen = new ArrayList<>();
        int at = 0;
        Matcher matcher = pattern.matcher(text);
        while (matcher.find()) {
            String term = terms.get(matcher.group(1).toLowerCase(Locale.ROOT));
            if (!seen.contains(term)) {
                seen.add(term);
                parts.add(Part.plain(text.substring(at, matcher.start())));
                parts.add(new Part(matcher.group(), term));
                at = matcher.end();
            }
        }
        parts.add(Part.plain(text.substring(at)));
        return parts;
    }
}
