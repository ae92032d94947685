package simgsm.console;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.module.ModuleDescriptor;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simgsm.file.FileErrors;

/**
 * The frame of every main: reads the options, answers {@code --help} and {@code --version}, and turns exceptions into a
 * line on standard error and an exit status.
 */
public final class Program {
    /** A system property: true if a process in a terminal has started this one and shows its output. */
    public static final String IN_TERMINAL = "simgsm.terminal";

    /** The work of a program. Returns the exit status. */
    public interface Body {
        int run(Arguments arguments) throws Exception;
    }

    /** Refuses invalid options that the program does not always read. */
    public interface Check {
        void check(Arguments arguments) throws UsageException;
    }

    /** Shows the reason why a program with a window could not start, and returns when its user has read it. */
    public interface StartErrors {
        /** @param arguments as far as they could be read */
        void show(String program, String text, Optional<Arguments> arguments);
    }

    /** Options of the programs with written files, and with read files. */
    private static final List<String> OUTPUTS = List.of("record", "track", "record-audio", "capture", "result");

    private static final String[] INPUTS = {"script", "world", "replay", "sim", "hlr", "town", "check", "pioneer-params"
    };

    private final String name;
    private final Options options;
    private Optional<StartErrors> startErrors = Optional.empty();
    private Check check = arguments -> {};
    private List<String> windowless = List.of();
    private String logLevel = LogSettings.DEFAULT;

    /** @param name as in messages, such as {@code simgsm-phone} */
    public Program(String name, Options options) {
        this.name = name;
        this.options = options;
    }

    /** Sets the level without {@code --log-level}, one of its words. */
    public Program logging(String level) {
        logLevel = level;
        return this;
    }

    /**
     * Shows errors in a window, too, unless an option is given that opens no window.
     *
     * @param withoutWindow these options without their hyphens
     */
    public Program showingErrors(StartErrors view, String... withoutWindow) {
        startErrors = Optional.of(view);
        windowless = List.of(withoutWindow);
        return this;
    }

    /** Checks the options of windows in every case. */
    public Program checking(Check windowOptions) {
        check = windowOptions;
        return this;
    }

    /** Runs and ends the process with the resulting status. */
    public void runAndExit(String[] args, Body body) {
        System.exit(run(List.of(args), standardOutput(), System.err, body));
    }

    /** Runs and returns the exit status; does not end the process. */
    public int run(List<String> args, PrintStream out, PrintStream err, Body body) {
        if (out instanceof StandardOutput standard) {
            standard.setProgram(name);
            int status = perform(args, out, err, body);
            return standard.hasFailed(err) ? ExitStatus.INPUT_OUTPUT : status;
        }
        return perform(args, out, err, body);
    }

    private int perform(List<String> args, PrintStream out, PrintStream err, Body body) {
        Optional<Arguments> given = Optional.empty();
        try {
            requireReadable(args);
            Arguments arguments = options.parse(args);
            given = Optional.of(arguments);
            if (arguments.has("help") || arguments.has("version")) {
                String versionLine = name + " " + version(body.getClass()) + "\n";
                out.print(arguments.has("help") ? options.help(arguments.prefersSpanish()) : versionLine);
                out.flush();
                return ExitStatus.OK;
            }
            LogSettings.apply(arguments.text("log-level").orElse(hasWindow(args) ? LogSettings.WITH_WINDOW : logLevel));
            check.check(arguments);
            requireScript(arguments);
            for (String output : OUTPUTS) {
                arguments.requireOtherFile(output, INPUTS);
            }
            return body.run(arguments);
        } catch (UsageException e) {
            err.println(name + ": " + e.getMessage() + "; see --help");
            if (System.console() == null && !Boolean.getBoolean(IN_TERMINAL)) {
                showError(args, given, e.getMessage());
            }
            return ExitStatus.USAGE;
        } catch (UnavailableException e) {
            return failed(ExitStatus.UNAVAILABLE, e, err, args, given);
        } catch (IOException | UncheckedIOException e) {
            return failed(ExitStatus.INPUT_OUTPUT, e, err, args, given);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return ExitStatus.FAILED;
        } catch (Exception e) {
            System.getLogger(Program.class.getName()).log(System.Logger.Level.DEBUG, "the run failed", e);
            return failed(ExitStatus.FAILED, e, err, args, given);
        }
    }

    private int failed(int status, Exception e, PrintStream err, List<String> args, Optional<Arguments> given) {
        err.println(name + ": " + describe(e));
        showError(args, given, describe(e));
        return status;
    }

    private void showError(List<String> args, Optional<Arguments> given, String text) {
        if (hasWindow(args)) {
            startErrors.orElseThrow().show(name, text, given);
        }
    }

    private boolean hasWindow(List<String> args) {
        return startErrors.isPresent()
                && windowless.stream()
                        .map(option -> "--" + option)
                        .noneMatch(option ->
                                args.stream().anyMatch(word -> word.equals(option) || word.startsWith(option + "=")));
    }

    /** Java replaces argument octets outside the locale's encoding. */
    private static void requireReadable(List<String> args) throws UsageException {
        for (String argument : args) {
            if (argument.indexOf('\uFFFD') >= 0
                    || argument.chars().anyMatch(c -> Character.isSurrogate((char) c))
                            && !argument.equals(
                                    new String(argument.getBytes(StandardCharsets.UTF_8), StandardCharsets.UTF_8))) {
                throw new UsageException("the argument " + argument + " has characters that this locale cannot read;"
                        + " expected UTF-8 and a UTF-8 locale, as LC_ALL=C.UTF-8");
            }
        }
    }

    /** Fails before the program starts if the script cannot be read. */
    private static void requireScript(Arguments arguments) throws UsageException, IOException {
        Optional<Path> script = arguments.path("script");
        if (script.isPresent()) {
            if (Files.isDirectory(script.get())) {
                throw new FileSystemException(script.get().toString(), null, "expected a file, found a folder");
            }
            Files.newInputStream(script.get()).close();
        }
    }

    /** The version of the jar, or of the image's module, with this class. */
    public static String version(Class<?> member) {
        return Optional.ofNullable(member.getPackage().getImplementationVersion())
                .or(() ->
                        Optional.ofNullable(member.getModule().getDescriptor()).flatMap(ModuleDescriptor::rawVersion))
                .orElse("(not packaged)");
    }

    /** The text of an exception for a user. */
    public static String describe(Exception e) {
        if (e instanceof UncheckedIOException unchecked) {
            return FileErrors.describe(unchecked.getCause());
        }
        if (e instanceof IOException failed) {
            return FileErrors.describe(failed);
        }
        return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }

    /** Standard output as UTF-8 in every locale; {@link #run} fails if a write fails. */
    public static PrintStream standardOutput() {
        return StandardOutput.STREAM;
    }

    /** Standard input; empty if it is closed. */
    private static InputStream standardInput() {
        return isStandardInputClosed() ? InputStream.nullInputStream() : System.in;
    }

    /** If standard input is closed, Linux gives its number to the first file opened by the Java machine. */
    private static boolean isStandardInputClosed() {
        try {
            return Path.of("/proc/self/fd/0")
                    .toRealPath()
                    .startsWith(Path.of(System.getProperty("java.home")).toRealPath());
        } catch (IOException e) {
            // A pipe, or another operating system.
            return false;
        }
    }

    /**
     * Performs the commands of {@code --script FILE}, if given, then those of standard input, until {@code quit} or the
     * end; with {@code --serve}, blocks after the end of input.
     *
     * @throws IOException if the script cannot be read
     */
    public static void runConsole(Console console, Arguments arguments, Console.Commands commands)
            throws IOException, InterruptedException, UsageException {
        Optional<Path> script = arguments.path("script");
        if (script.isPresent()) {
            Path file = script.get();
            try (InputStream in = Files.newInputStream(file)) {
                if (console.run(new CommandLines(file.toString(), in), commands)) {
                    return;
                }
            }
        }
        boolean quit = console.run(new CommandLines("standard input", standardInput()), commands);
        if (!quit && arguments.has("serve")) {
            new java.util.concurrent.CountDownLatch(1).await();
        }
    }
}
