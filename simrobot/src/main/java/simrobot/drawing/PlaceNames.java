package simrobot.drawing;

import java.util.Locale;
import java.util.ResourceBundle;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names of furniture, homes and goals in the user's language if they are usual words; else as in the world's file. */
public final class PlaceNames {
    /** All names as in the file. */
    public static final PlaceNames OF_FILE = new PlaceNames(null);

    /** A word, and a number or letter after it: {@code Desk 2}, {@code Office1}, {@code Bench A}. */
    private static final Pattern NUMBERED = Pattern.compile("(\\p{L}{2,}?)( ?[0-9]+| [A-Z])?");

    /** Null for the names of the file. */
    private final ResourceBundle words;

    private PlaceNames(ResourceBundle words) {
        this.words = words;
    }

    public static PlaceNames in(Locale language) {
        return language.getLanguage().equals("es")
                ? new PlaceNames(ResourceBundle.getBundle("simrobot.drawing.places", language))
                : OF_FILE;
    }

    /** The name to show. */
    public String of(String name) {
        Matcher parts = NUMBERED.matcher(name);
        if (words == null || !parts.matches() || !words.containsKey(parts.group(1))) {
            return name;
        }
        return words.getString(parts.group(1)) + (parts.group(2) == null ? "" : parts.group(2));
    }
}
