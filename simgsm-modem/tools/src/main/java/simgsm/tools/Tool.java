package simgsm.tools;

import java.io.PrintStream;
import java.util.List;
import simgsm.console.Arguments;
import simgsm.console.Options;

/** One word of the command line: {@code simgsm-modem.jar WORD ...}. */
public interface Tool {
    /** In the order in which the help lists them. */
    List<Tool> ALL =
            List.of(new TonesTool(), new DecodeTool(), new GsmTool(), new PduTool(), new LoadTool(), new FuzzTool());

    String word();

    Options options();

    /** What is logged unless the user says otherwise. */
    default String logLevel() {
        return "warning";
    }

    /** Does the work. @return the exit status */
    int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception;
}
