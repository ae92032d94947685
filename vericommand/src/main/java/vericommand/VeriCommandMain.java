package vericommand;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.lang.module.ModuleDescriptor;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** Prints the verdict on an order, from the command line. */
public final class VeriCommandMain {
    private static final Set<String> WITHOUT_VALUE = Set.of("--help", "--version", "--diagram");
    private static final int ACCEPTED = 0;
    private static final int NOT_ACCEPTED = 1;
    private static final int USAGE = 2;
    private static final int INPUT_OUTPUT = 74;

    private final List<String> words = new ArrayList<>();
    private RobotStatus status = RobotStatus.STOPPED;
    private Locale language =
            Locale.getDefault().getLanguage().equals("es") ? Locale.forLanguageTag("es") : Locale.ENGLISH;

    private VeriCommandMain() {}

    public static void main(String[] args) {
        System.exit(run(List.of(args), standardStream(FileDescriptor.out), standardStream(FileDescriptor.err)));
    }

    /** @return the exit status */
    static int run(List<String> args, PrintStream out, PrintStream err) {
        try {
            requireReadable(args);
            int status = new VeriCommandMain().perform(args.iterator(), out);
            if (out.checkError()) {
                err.println("vericommand: standard output cannot be written");
                return INPUT_OUTPUT;
            }
            return status;
        } catch (IllegalArgumentException e) {
            err.println("vericommand: " + e.getMessage() + "; see --help");
            return USAGE;
        }
    }

    /** Java replaces argument octets outside the locale's encoding. */
    private static void requireReadable(List<String> args) {
        for (String argument : args) {
            if (argument.indexOf('\uFFFD') >= 0) {
                throw new IllegalArgumentException(
                        "the argument " + argument + " has characters that this locale cannot"
                                + " read; expected UTF-8 and a UTF-8 locale, as LC_ALL=C.UTF-8");
            }
        }
    }

    private int perform(Iterator<String> args, PrintStream out) {
        while (args.hasNext()) {
            String word = args.next();
            Optional<String> answer = option(word, args);
            if (answer.isPresent()) {
                out.print(answer.get());
                return ACCEPTED;
            }
        }
        if (words.isEmpty()) {
            throw new IllegalArgumentException("no order given; expected one such as \"** #**20 **\"");
        }
        return judge(String.join(" ", words).replaceAll("\\s", " "), out);
    }

    /**
     * Reads one word of the command line. @return the text of an option that prints one instead of a verdict; empty
     * for others
     */
    private Optional<String> option(String word, Iterator<String> args) {
        String[] parts = word.startsWith("--") ? word.split("=", 2) : new String[] {word};
        String value = parts.length > 1 ? parts[1] : null;
        if (value != null && WITHOUT_VALUE.contains(parts[0])) {
            throw new IllegalArgumentException(parts[0] + " takes no value, found " + value);
        }
        switch (parts[0]) {
            case "-h", "--help" -> {
                return Optional.of(help());
            }
            case "-V", "--version" -> {
                return Optional.of("vericommand " + version() + "\n");
            }
            case "--diagram" -> {
                // look.iuml is in docs/uml only; the output is complete without it.
                return Optional.of(StatusMachine.TABLE.plantUml().replace("!include look.iuml\n", ""));
            }
            case "--status" -> status = statusOf(value(word, value, args));
            case "--lang" -> language = languageOf(value(word, value, args));
            case "--" -> args.forEachRemaining(words::add);
            default -> {
                if (word.startsWith("-")) {
                    throw new IllegalArgumentException("unknown option " + word);
                }
                words.add(word);
            }
        }
        return Optional.empty();
    }

    private static String value(String option, String value, Iterator<String> args) {
        if (value != null) {
            return value;
        }
        if (!args.hasNext()) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return args.next();
    }

    private static RobotStatus statusOf(String text) {
        try {
            return RobotStatus.ofText(text);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("--status: " + e.getMessage(), e);
        }
    }

    private static Locale languageOf(String text) {
        if (!text.equals("en") && !text.equals("es")) {
            throw new IllegalArgumentException("--lang: expected en or es, found " + text);
        }
        return Locale.forLanguageTag(text);
    }

    private int judge(String text, PrintStream out) {
        ReplyTexts texts = new ReplyTexts(language);
        Verdict verdict = Verdict.of(OrderText.read(text), status);
        out.println(text);
        if (verdict instanceof Verdict.Invalid invalid) {
            out.println(" ".repeat(indexOfKey(text, invalid.fault().position())) + "^");
            out.println(texts.invalid(invalid.fault()).message());
            return NOT_ACCEPTED;
        }
        if (verdict instanceof Verdict.Refused refused) {
            out.println(refused.order().words(language));
            out.println(texts.refused(refused.tone(), refused.status()).message());
            return NOT_ACCEPTED;
        }
        out.println(((Verdict.Accepted) verdict).order().words(language));
        out.println(texts.text("verdict.accepted"));
        return ACCEPTED;
    }

    /** The index in the text, blanks counted, of the key at a position; the text's length if it has fewer keys. */
    private static int indexOfKey(String text, int position) {
        int keys = 0;
        for (int i = 0; i < text.length(); i++) {
            keys += OrderText.keysOf(text.substring(i, i + 1)).length();
            if (keys == position) {
                return i;
            }
        }
        return text.length();
    }

    private static String help() {
        return """
                Usage: java -jar vericommand.jar [--status STATUS] [--lang en|es] ORDER

                Tells the verdict on an order such as "** #**20 **": exit status 0 accepted, 1 refused or not valid.

                Options:
                  --status STATUS   in which status the robot is: Collision, Moving, Stopped (the default),
                                    "No motors" or Disconnected
                  --lang en|es      language of the answer; else the system's
                  --diagram         print the robot's status machine as a PlantUML diagram and end
                  -h, --help        print this and end
                  -V, --version     print the version and end
                """;
    }

    private static String version() {
        return Optional.ofNullable(VeriCommandMain.class.getPackage().getImplementationVersion())
                .or(() -> Optional.ofNullable(VeriCommandMain.class.getModule().getDescriptor())
                        .flatMap(ModuleDescriptor::rawVersion))
                .orElse("(not packaged)");
    }

    private static PrintStream standardStream(FileDescriptor descriptor) {
        return new PrintStream(new FileOutputStream(descriptor), true, StandardCharsets.UTF_8);
    }
}
