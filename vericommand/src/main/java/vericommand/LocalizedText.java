package vericommand;

import java.util.Locale;
import java.util.function.Function;

/** A text in both languages, for a window that changes its language while it shows the text. */
public record LocalizedText(String english, String spanish) {
    static final LocalizedText EMPTY = new LocalizedText("", "");

    /** @param inLanguage gives the text in a language */
    static LocalizedText of(Function<Locale, String> inLanguage) {
        return new LocalizedText(inLanguage.apply(Locale.ENGLISH), inLanguage.apply(new Locale("es")));
    }

    /** The text in Spanish, or in English for every other language. */
    public String in(Locale language) {
        return "es".equals(language.getLanguage()) ? spanish : english;
    }
}
