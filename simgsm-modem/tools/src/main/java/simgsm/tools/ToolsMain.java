package simgsm.tools;

import java.io.PrintStream;
import java.util.List;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UsageException;

/** {@code simgsm-modem.jar}: the command-line tools, chosen by the first word. */
public final class ToolsMain {
    private static final String NAME = "simgsm-modem";

    private ToolsMain() {}

    public static void main(String[] args) {
        PrintStream out = Program.standardOutput();
        int status = run(List.of(args), out, System.err);
        out.flush();
        System.exit(status);
    }

    static int run(List<String> words, PrintStream out, PrintStream err) {
        for (Tool tool : Tool.ALL) {
            if (!words.isEmpty() && words.get(0).equals(tool.word())) {
                return new Program(NAME, tool.options())
                        .logging(tool.logLevel())
                        .run(
                                words.subList(1, words.size()),
                                out,
                                err,
                                arguments -> tool.body().run(arguments, out, err));
            }
        }
        return new Program(NAME, overview()).run(words, out, err, arguments -> {
            throw new UsageException(
                    arguments.rest().isEmpty()
                            ? "missing a tool"
                            : "unknown tool " + arguments.rest().get(0));
        });
    }

    private static Options overview() {
        StringBuilder usage = new StringBuilder();
        for (Tool tool : Tool.ALL) {
            String[] lines = tool.options().help(false).split("\n");
            usage.append(usage.length() == 0 ? "" : "\n       ").append(lines[0].replace("Usage: ", ""));
        }
        return new Options(
                        usage.toString(),
                        "Tools for DTMF, speech, short messages and load; TOOL --help describes each.")
                .arguments(Integer.MAX_VALUE);
    }
}
