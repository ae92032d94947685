package simgsm.tools;

import java.io.PrintStream;
import java.util.List;
import simgsm.console.Arguments;
import simgsm.console.Options;

/**
 * One tool of the command line: {@code simgsm-modem.jar WORD ...}.
 *
 * @param logLevel in force without {@code --log-level}
 */
record Tool(String word, String logLevel, Options options, Body body) {
    /** In the order of the help. */
    static final List<Tool> ALL =
            List.of(TonesTool.TOOL, DecodeTool.TOOL, GsmTool.TOOL, PduTool.TOOL, LoadTool.TOOL, FuzzTool.TOOL);

    private static final String LOG_LEVEL = "warning";

    /** Does the work. Returns the exit status. */
    interface Body {
        int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception;
    }

    Tool(String word, Options options, Body body) {
        this(word, LOG_LEVEL, options, body);
    }
}
