package simgsm.ui.window;

import java.awt.Toolkit;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import javax.swing.JComponent;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;

/** The options {@code --theme}, {@code --zoom}, {@code --window} and {@code --lang} of all windows. */
public final class WindowOptions {
    private static final int HUNDRED_PERCENT = 100;

    private WindowOptions() {}

    /** Refuses invalid values of window options, also if no window opens. */
    public static void check(Arguments arguments) throws UsageException {
        if (arguments.has("theme") && !arguments.text("theme").orElseThrow().equalsIgnoreCase("system")) {
            arguments.value("theme", Appearance::parse);
        }
        arguments.value("window", WindowPlace::parse);
        zoomPercent(arguments);
        arguments.language();
    }

    static Appearance appearance(String text) {
        return text.equalsIgnoreCase("system") ? systemAppearance() : Appearance.parse(text);
    }

    /** The desktop's appearance by its GTK theme's name; light without one. */
    static Appearance systemAppearance() {
        Object name = System.getenv("GTK_THEME");
        if (name == null && Display.isAvailable()) {
            name = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
        }
        String lower = String.valueOf(name).toLowerCase(Locale.ROOT);
        return lower.endsWith("dark") || lower.endsWith("-inverse") ? Appearance.DARK : Appearance.LIGHT;
    }

    /** The value of {@code --zoom}; empty without it. */
    public static OptionalInt zoomPercent(Arguments arguments) throws UsageException {
        return arguments.has("zoom")
                ? OptionalInt.of(
                        (int) arguments.integer("zoom", HUNDRED_PERCENT, (int) (Theme.ZOOM_MIN * HUNDRED_PERCENT), (int)
                                (Theme.ZOOM_MAX * HUNDRED_PERCENT)))
                : OptionalInt.empty();
    }

    /** Options that give a started program the current language, zoom and colours of this one. */
    public static List<String> presentLook() {
        String language = JComponent.getDefaultLocale().getLanguage();
        String zoom = String.valueOf(Math.round(Theme.zoom() * HUNDRED_PERCENT));
        String theme = Theme.appearance().word();
        return List.of("--lang", language, "--zoom", zoom, "--theme", theme);
    }
}
