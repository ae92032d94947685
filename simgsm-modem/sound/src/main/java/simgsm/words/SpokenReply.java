package simgsm.words;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Reads a robot's reply with the prompts of its language. A clause that holds anything else, such as the name of a
 * process or the keys of an order, is not said, nor is the rest of its sentence.
 */
public final class SpokenReply {
    private static final int LONGEST_PHRASE = 6;

    private final SpokenLanguage language;
    /** The prompts by their words in small letters without accents: replies have letters of the GSM alphabet only. */
    private final Map<String, String> phrases = new HashMap<>();

    public SpokenReply(Prompts prompts) {
        language = prompts.language();
        prompts.names().forEach(name -> phrases.put(plain(name), name));
    }

    private static String plain(String text) {
        return Normalizer.normalize(text.toLowerCase(Locale.ROOT), Normalizer.Form.NFD)
                .replaceAll("\\p{M}", "");
    }

    /** @param text a reply such as {@code Done: #**20. Stopped at 1.200 0.500 m, heading 90.0.} */
    public Utterance read(String text) {
        List<String> words = new ArrayList<>();
        String expanded = text.replaceAll(
                        "(-?\\d+\\.\\d{3}) (-?\\d+\\.\\d{3}) m\\b", language.x() + " $1m " + language.y() + " $2m")
                .replaceAll("(\\d+)\\.\\.(\\d+)", "$1 " + language.range() + " $2");
        for (String sentence : expanded.split("\\.(?:\\s+|$)")) {
            boolean isSaid = true;
            for (String clause : sentence.split("[:,]\\s+")) {
                List<String> said = new ArrayList<>();
                isSaid = isSaid && readClause(clause.strip().split("\\s+"), said);
                words.addAll(isSaid ? said : List.of());
            }
        }
        return new Utterance(words);
    }

    /** @return false if a token has no prompt */
    private boolean readClause(String[] tokens, List<String> words) {
        for (int at = 0; at < tokens.length; ) {
            String token = tokens[at];
            if (token.matches("-?\\d+\\.\\d{3}m")) {
                words.addAll(language.meters(token.substring(0, token.length() - 1)));
                at++;
            } else if (token.matches("-?\\d+(\\.\\d+)?")) {
                at += readNumber(tokens, at, words);
            } else {
                int taken = readPhrase(tokens, at, words);
                if (taken == 0) {
                    return false;
                }
                at += taken;
            }
        }
        return true;
    }

    /** A number alone, or a whole one with the unit or the noun that follows. */
    private int readNumber(String[] tokens, int at, List<String> words) {
        String next = at + 1 < tokens.length ? language.expand(tokens[at + 1]) : "";
        String singular = next.replaceFirst("s$", "");
        if (tokens[at].equals("1") && !singular.equals(next) && phrases.containsKey(plain(singular))) {
            words.addAll(language.amount(1, next));
            return 2;
        }
        words.addAll(language.number(tokens[at], noun(next)));
        return 1;
    }

    private String noun(String next) {
        String name = phrases.getOrDefault(plain(next), "");
        return name.endsWith("s") ? name : "";
    }

    /** The longest phrase that begins there. @return the number of its words, 0 for none */
    private int readPhrase(String[] tokens, int at, List<String> words) {
        for (int count = Math.min(LONGEST_PHRASE, tokens.length - at); count > 0; count--) {
            StringBuilder phrase = new StringBuilder();
            for (int i = at; i < at + count; i++) {
                phrase.append(i > at ? " " : "").append(language.expand(tokens[i]));
            }
            String prompt = phrases.get(plain(phrase.toString()));
            if (prompt != null) {
                words.add(prompt);
                return count;
            }
        }
        return 0;
    }
}
