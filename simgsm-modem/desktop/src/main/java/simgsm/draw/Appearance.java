package simgsm.draw;

import java.util.Locale;

/** Light or dark. */
public enum Appearance {
    LIGHT,
    DARK;

    public Appearance other() {
        return this == LIGHT ? DARK : LIGHT;
    }

    /** Reads "light" or "dark". IllegalArgumentException names the values of the option {@code --theme}. */
    public static Appearance parse(String text) {
        return switch (text.toLowerCase(Locale.ROOT)) {
            case "light" -> LIGHT;
            case "dark" -> DARK;
            default -> throw new IllegalArgumentException("\"" + text + "\" is not light, dark or system");
        };
    }
}
