package simgsm.tools;

import java.io.IOException;
import java.io.PrintStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.tools.load.LoadGenerator;
import simgsm.tools.load.LoadOptions;
import simgsm.tools.load.LoadResult;

/** {@code load}: many stations on a running centre, and their measurements. */
final class LoadTool {
    private static final HostPort DEFAULT_CENTER = new HostPort("127.0.0.1", 3003);
    private static final int CONNECT_MILLIS = 5_000;

    private LoadTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        LoadOptions options = options(arguments);
        requireCenter(options.center());
        LoadResult result = new LoadGenerator(options).run();
        out.print(result.line() + "\n");
        out.flush();
        if (!result.isComplete()) {
            err.println("simgsm-modem: load: " + result.shortfall());
            return ExitStatus.FAILED;
        }
        return ExitStatus.OK;
    }

    private static LoadOptions options(Arguments arguments) throws UsageException {
        try {
            return new LoadOptions(
                    arguments.hostPort("center").orElse(DEFAULT_CENTER),
                    arguments.integer("first-number", 7_000_000, 1, Long.MAX_VALUE),
                    integer(arguments, "phones", 100),
                    integer(arguments, "calls", 0),
                    integer(arguments, "sms", 0),
                    integer(arguments, "seconds", 10),
                    integer(arguments, "answer-after", 0));
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage());
        }
    }

    private static int integer(Arguments arguments, String name, int otherwise) throws UsageException {
        return (int) arguments.integer(name, otherwise, 0, Integer.MAX_VALUE);
    }

    /** Fails at once without a centre; the stations would retry for ever. */
    private static void requireCenter(HostPort center) throws UnavailableException {
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(center.host(), center.port()), CONNECT_MILLIS);
        } catch (IOException e) {
            throw new UnavailableException("no centre at " + center + ": " + e.getMessage());
        }
    }
}
