package simgsm.words;

import java.util.List;
import java.util.Locale;

/**
 * A sentence as its prompts, in order.
 *
 * @param prompts names of {@link Prompts}; a part of a word has a {@code -} where it is joined
 */
public record Utterance(List<String> prompts) {
    public Utterance {
        prompts = List.copyOf(prompts);
    }

    /** The caption: the words, the first one with a capital letter. */
    public String text() {
        String words = String.join(" ", prompts).replace(" -", "").replace("- ", "");
        return words.isEmpty() ? "" : words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }
}
