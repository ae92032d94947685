package simgsm.ui;

import java.awt.Toolkit;
import java.util.Locale;

/** Light or dark. */
public enum Appearance {
    LIGHT,
    DARK;

    public Appearance other() {
        return this == LIGHT ? DARK : LIGHT;
    }

    /** Reads an option's value: light, dark, or system. IllegalArgumentException names what was expected. */
    public static Appearance parse(String text) {
        return switch (text.toLowerCase(Locale.ROOT)) {
            case "light" -> LIGHT;
            case "dark" -> DARK;
            case "system" -> ofSystem();
            default -> throw new IllegalArgumentException("\"" + text + "\" is not light, dark or system");
        };
    }

    /** What the desktop asks for, as far as Java can see it: GTK tells by the theme's name; otherwise light. */
    public static Appearance ofSystem() {
        String environment = System.getenv("GTK_THEME");
        if (environment != null) {
            return isDarkName(environment) ? DARK : LIGHT;
        }
        if (!Display.isThere()) {
            return LIGHT;
        }
        Object name = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
        return name != null && isDarkName(name.toString()) ? DARK : LIGHT;
    }

    private static boolean isDarkName(String themeName) {
        String lower = themeName.toLowerCase(Locale.ROOT);
        return lower.endsWith("dark") || lower.endsWith("-inverse");
    }
}
