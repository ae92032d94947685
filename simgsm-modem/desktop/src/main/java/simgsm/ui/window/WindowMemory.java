package simgsm.ui.window;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.TreeMap;
import java.util.stream.Stream;
import simgsm.console.Arguments;
import simgsm.draw.Appearance;
import simgsm.file.FileReplacement;
import simgsm.ui.Theme;

/**
 * Values that windows keep from one run to the next: each its place, size and zoom, all together theme and language.
 * Small files in the user's folder of settings hold them as values of the options {@code --window}, {@code --zoom},
 * {@code --theme} and {@code --lang}, and are used for options missing on the command line. An invalid value is
 * ignored. Nothing is kept without a display, with {@code --headless} or with {@code --fresh}.
 */
public final class WindowMemory {
    private static final System.Logger LOG = System.getLogger(WindowMemory.class.getName());

    /** The option that names the window's file; its value is added by {@link #recall}. */
    private static final String NAME = "remember-as";

    private static final String ALL_WINDOWS = "all";
    private static final String SCREEN = "screen";
    private static final String ENDING = ".properties";
    private static final String OURS = "simgsm";

    private final Path folder;

    /** A memory in a folder, which is made by the first write. */
    public WindowMemory(Path folder) {
        this.folder = folder;
    }

    private static WindowMemory ofUser() {
        return new WindowMemory(folder(System.getenv(), System.getProperties()));
    }

    /** {@code $XDG_CONFIG_HOME/simgsm} if that is set to an absolute path, else the platform's usual folder. */
    static Path folder(Map<String, String> environment, Properties system) {
        Path home = Path.of(system.getProperty("user.home"));
        String os = system.getProperty("os.name", "");
        Path usual = home.resolve(".config");
        if (os.startsWith("Windows")) {
            usual = absolute(environment.get("APPDATA"))
                    .orElse(home.resolve("AppData").resolve("Roaming"));
        } else if (os.startsWith("Mac")) {
            usual = home.resolve("Library").resolve("Preferences");
        }
        return absolute(environment.get("XDG_CONFIG_HOME")).orElse(usual).resolve(OURS);
    }

    private static Optional<Path> absolute(String text) {
        return Optional.ofNullable(text).map(Path::of).filter(Path::isAbsolute);
    }

    /**
     * The command line with remembered values of missing options.
     *
     * @param window name of the window's own values, unless {@code --remember-as} gives another
     */
    public static Arguments recall(Arguments arguments, String window) {
        if (arguments.has("headless") || arguments.has("fresh") || !Display.isAvailable()) {
            return arguments;
        }
        return ofUser().recall(arguments, window, Display.screens());
    }

    Arguments recall(Arguments arguments, String window, List<WindowPlace> screens) {
        String name = arguments.text(NAME).orElse(window);
        Map<String, String> values = new TreeMap<>(read(ALL_WINDOWS));
        values.putAll(read(name));
        String screen = values.remove(SCREEN);
        if (!String.valueOf(screens).equals(screen) || arguments.has("zoom")) {
            values.remove("window");
        }
        values.entrySet().removeIf(value -> !isGood(value.getKey(), value.getValue()));
        values.put(NAME, name);
        return arguments.or(values);
    }

    /** The last place of a window of this name on the current screens. */
    public static Optional<WindowPlace> place(Arguments arguments, String window) {
        return arguments.has(NAME)
                ? ofUser().recall(arguments.without(NAME, "window", "zoom"), window, Display.screens())
                        .text("window")
                        .map(WindowPlace::parse)
                : Optional.empty();
    }

    private static boolean isGood(String option, String value) {
        try {
            return switch (option) {
                case "lang" -> List.of("en", "es").contains(value);
                case "theme" -> Appearance.parse(value) != null;
                case "zoom" ->
                    Integer.parseInt(value) >= Theme.ZOOM_MIN * 100 && Integer.parseInt(value) <= Theme.ZOOM_MAX * 100;
                case "window" -> WindowPlace.parse(value) != null;
                default -> false;
            };
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    /** The memory that {@link #recall} has read for a window; empty if nothing is remembered. */
    public static Optional<WindowMemory> of(Arguments arguments) {
        return arguments.has(NAME) && !arguments.has("fresh") ? Optional.of(ofUser()) : Optional.empty();
    }

    /** Options that keep a started program from remembering if this one does not remember. */
    public static List<String> passedOn(Arguments arguments) {
        return arguments.has(NAME) && !arguments.has("fresh") ? List.of() : List.of("--fresh");
    }

    static String nameOf(Arguments arguments) {
        return arguments.text(NAME).orElseThrow();
    }

    /** Keeps a window's place and zoom. */
    void keep(String window, WindowPlace place, int zoomPercent, List<WindowPlace> screens) {
        write(
                window,
                Map.of(
                        "window",
                        place.toString(),
                        SCREEN,
                        String.valueOf(screens),
                        "zoom",
                        Integer.toString(zoomPercent)));
    }

    /** Keeps a value of all windows, such as {@code theme}. */
    void keep(String option, String value) {
        Map<String, String> values = new TreeMap<>(read(ALL_WINDOWS));
        values.put(option, value);
        write(ALL_WINDOWS, values);
    }

    /** The stored values of all windows. */
    Map<String, String> shared() {
        Map<String, String> values = new TreeMap<>(read(ALL_WINDOWS));
        values.entrySet().removeIf(value -> !isGood(value.getKey(), value.getValue()));
        return values;
    }

    /** Keeps a list under a name that no window has; at most 99 items. */
    public void keepList(String name, List<String> items) {
        Map<String, String> values = new TreeMap<>();
        for (int i = 0; i < items.size(); i++) {
            values.put(String.format(Locale.ROOT, "%02d", i), items.get(i));
        }
        write(name, values);
    }

    /** A stored list; empty if there is none. */
    public List<String> list(String name) {
        return List.copyOf(read(name).values());
    }

    /** Removes all remembered values. */
    public void forget() {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file :
                    files.filter(each -> each.toString().endsWith(ENDING)).toList()) {
                Files.delete(file);
            }
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "nothing to forget in {0}", folder);
        }
    }

    Path folder() {
        return folder;
    }

    private Path file(String name) {
        return folder.resolve(name.replaceAll("[^A-Za-z0-9-]", "_") + ENDING);
    }

    private Map<String, String> read(String name) {
        Properties read = new Properties();
        try (InputStream in = Files.newInputStream(file(name))) {
            read.load(in);
        } catch (IOException | IllegalArgumentException e) {
            return Map.of(); // nothing was kept, or something else wrote the file
        }
        Map<String, String> values = new TreeMap<>();
        read.stringPropertyNames().forEach(key -> values.put(key, read.getProperty(key)));
        return values;
    }

    /** Replaces the file in one step. If it cannot be written, nothing is remembered. */
    private void write(String name, Map<String, String> values) {
        Properties written = new Properties();
        written.putAll(values);
        try {
            Files.createDirectories(folder);
            ByteArrayOutputStream octets = new ByteArrayOutputStream();
            written.store(octets, null);
            FileReplacement.write(file(name), octets.toByteArray());
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "cannot remember the window: {0}", e.getMessage());
        }
    }
}
