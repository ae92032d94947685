package simgsm.tools;

import java.io.PrintStream;
import java.util.List;
import simgsm.console.Arguments;
import simgsm.console.Options;

/**
 * One tool of the command line: {@code simgsm-modem.jar WORD ...}. The resource {@code WORD.txt} has its options.
 *
 * @param logLevel without {@code --log-level}
 * @param arguments most arguments other than options
 */
record Tool(String word, String logLevel, int arguments, Body body) {
    /** In the order of the help. */
    static final List<Tool> ALL = List.of(
            new Tool("tones", "warning", 2, TonesTool::run),
            new Tool("decode", "warning", Integer.MAX_VALUE, DecodeTool::run),
            new Tool("gsm", "warning", 3, GsmTool::run),
            new Tool("say", "warning", Integer.MAX_VALUE, SayTool::run),
            new Tool("enrol", "warning", Integer.MAX_VALUE, WordTools::enrol),
            new Tool("hear", "warning", Integer.MAX_VALUE, WordTools::hear),
            new Tool("pdu", "warning", 2, PduTool::run),
            new Tool("load", "warning", 0, LoadTool::run));

    /** Runs the tool. Returns the exit status. */
    interface Body {
        int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception;
    }

    Options options() {
        return Options.read(Tool.class.getResourceAsStream(word + ".txt")).arguments(arguments);
    }
}
