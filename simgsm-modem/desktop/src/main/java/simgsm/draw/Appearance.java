package simgsm.draw;

import java.util.Locale;

/** Light, dark, or high contrast: black and strong colours on white, for projectors and impaired sight. */
public enum Appearance {
    LIGHT,
    DARK,
    CONTRAST;

    /** The next appearance; the first after the last. */
    public Appearance next() {
        return values()[(ordinal() + 1) % values().length];
    }

    /** The word of the option {@code --theme}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Reads "light", "dark" or "contrast". IllegalArgumentException names the values of the option {@code --theme}. */
    public static Appearance parse(String text) {
        for (Appearance appearance : values()) {
            if (appearance.word().equalsIgnoreCase(text)) {
                return appearance;
            }
        }
        throw new IllegalArgumentException("\"" + text + "\" is not light, dark, contrast or system");
    }
}
