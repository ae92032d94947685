package simgsm.console;

import java.io.IOException;
import java.math.BigInteger;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** The options and arguments of a command line, converted to types; errors name the option. */
public final class Arguments {
    private final Map<String, List<String>> given;
    private final List<String> rest;

    Arguments(Map<String, List<String>> given, List<String> rest) {
        this.given = given;
        this.rest = List.copyOf(rest);
    }

    /** A copy with one more option, or another value of it. */
    public Arguments with(String name, String value) {
        Map<String, List<String>> more = new LinkedHashMap<>(given);
        more.put(name, List.of(value));
        return new Arguments(more, rest);
    }

    public boolean has(String name) {
        return given.containsKey(name);
    }

    /** A copy with these values of options that were not given. */
    public Arguments or(Map<String, String> values) {
        Map<String, List<String>> all = new LinkedHashMap<>(given);
        values.forEach((name, value) -> all.putIfAbsent(name, List.of(value)));
        return new Arguments(all, rest);
    }

    /** A copy without these options. */
    public Arguments without(String... names) {
        Map<String, List<String>> others = new LinkedHashMap<>(given);
        others.keySet().removeAll(List.of(names));
        return new Arguments(others, rest);
    }

    /** The arguments other than options. */
    public List<String> rest() {
        return rest;
    }

    /** The last value of an option. */
    public Optional<String> text(String name) {
        return Optional.ofNullable(given.get(name)).map(values -> values.get(values.size() - 1));
    }

    /** All values of a collecting option, in order. */
    public List<String> all(String name) {
        return List.copyOf(given.getOrDefault(name, List.of()));
    }

    /** The value as a path. */
    public Optional<Path> path(String name) throws UsageException {
        return value(name, text -> {
            if (text.isEmpty()) {
                throw new IllegalArgumentException("expected the name of a file or folder, found nothing");
            }
            return Path.of(text);
        });
    }

    /** The address of {@code --bind}; loopback without it. */
    public InetAddress bindAddress() throws UsageException {
        return value("bind", text -> {
                    try {
                        if (!text.isBlank()) {
                            return InetAddress.getByName(text);
                        }
                    } catch (UnknownHostException e) {
                        // A blank text gets the exception below, since Java takes it for loopback.
                    }
                    throw new IllegalArgumentException(
                            "expected an address of this machine, found " + (text.isBlank() ? "nothing" : text));
                })
                .orElse(InetAddress.getLoopbackAddress());
    }

    /**
     * Refuses to write to a file that is also read.
     *
     * @param output option with the written file
     * @param inputs options with the read files
     */
    public void requireOtherFile(String output, String... inputs) throws UsageException, IOException {
        Optional<Path> written = path(output).filter(Files::exists);
        for (String input : inputs) {
            Optional<Path> read = path(input).filter(Files::exists);
            if (written.isPresent() && read.isPresent() && Files.isSameFile(written.get(), read.get())) {
                throw new UsageException(
                        "--" + output + ": expected another file than that of --" + input + ", found " + written.get());
            }
        }
    }

    /** The value as {@code HOST:PORT}. */
    public Optional<HostPort> hostPort(String name) throws UsageException {
        return value(name, HostPort::parse);
    }

    /**
     * A value converted by {@code reader}.
     *
     * @param reader throws IllegalArgumentException naming the expected form
     */
    public <T> Optional<T> value(String name, Function<String, T> reader) throws UsageException {
        Optional<String> text = text(name);
        try {
            return text.map(reader);
        } catch (IllegalArgumentException e) {
            throw new UsageException("--" + name + ": " + e.getMessage());
        }
    }

    /** The result of {@code source}; its IllegalArgumentException becomes a usage error with the same text. */
    public static <T> T checked(Supplier<T> source) throws UsageException {
        try {
            return source.get();
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage());
        }
    }

    /** A whole number within bounds, both included. */
    public long integer(String name, long otherwise, long least, long most) throws UsageException {
        return value(name, text -> {
                    if (text.matches("-?[0-9]{1,19}") && new BigInteger(text).bitLength() < Long.SIZE) {
                        long number = Long.parseLong(text);
                        if (number >= least && number <= most) {
                            return number;
                        }
                    }
                    throw new IllegalArgumentException(
                            "expected a whole number of " + least + " to " + most + ", found " + text);
                })
                .orElse(otherwise);
    }

    /** A number within bounds, both included. */
    public double number(String name, double otherwise, double least, double most) throws UsageException {
        return value(name, text -> {
                    if (text.matches("[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?|\\.[0-9]+")) {
                        double number = Double.parseDouble(text);
                        if (number >= least && number <= most) {
                            return number;
                        }
                    }
                    throw new IllegalArgumentException(
                            "expected a number of " + least + " to " + most + ", found " + text);
                })
                .orElse(otherwise);
    }

    /** One of these words; the first if the option is missing. */
    public String choice(String name, String... words) throws UsageException {
        return value(name, text -> {
                    if (List.of(words).contains(text)) {
                        return text;
                    }
                    throw new IllegalArgumentException("expected " + String.join(" or ", words) + ", found " + text);
                })
                .orElse(words[0]);
    }

    /** The language of {@code --lang en|es}; without it Spanish on a Spanish system, else English. */
    public Locale language() throws UsageException {
        if (has("lang")) {
            choice("lang", "en", "es");
        }
        return Locale.forLanguageTag(prefersSpanish() ? "es" : "en");
    }

    /** True for Spanish by {@code --lang} or else by the system; any other word of {@code --lang} is English. */
    boolean prefersSpanish() {
        return text("lang").map("es"::equals).orElseGet(() -> isSpanish(System.getenv(), Locale.getDefault()));
    }

    /** Java takes no language from LANG on a system without that locale, as in containers. */
    static boolean isSpanish(Map<String, String> environment, Locale system) {
        return system.getLanguage().equals("es")
                || Stream.of("LC_ALL", "LC_MESSAGES", "LANG")
                        .map(name -> environment.getOrDefault(name, ""))
                        .filter(value -> !value.isEmpty())
                        .findFirst()
                        .filter(value -> value.matches("es([_.@].*)?"))
                        .isPresent();
    }
}
