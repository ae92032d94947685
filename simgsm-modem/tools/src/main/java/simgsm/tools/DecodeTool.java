package simgsm.tools;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.dtmf.DtmfReceiver;

/** {@code decode FILE...}: the DTMF keys in sound files, a line per file. */
final class DecodeTool {
    private DecodeTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        List<String> names = arguments.rest();
        if (names.isEmpty()) {
            throw new UsageException("missing FILE.wav");
        }
        DecodedFile.Kind kind = new DecodedFile.Kind(
                arguments.has("explain"),
                arguments.number("limit", DtmfReceiver.LIMIT, 0, 100),
                arguments.choice("receiver", "likelihood", "classic").equals("classic"),
                Integer.parseInt(arguments.choice("block", "102", "205")));
        if (names.size() == 1) {
            return print(DecodedFile.of(names.get(0), kind), out, err);
        }
        int threads = Math.min(names.size(), Runtime.getRuntime().availableProcessors());
        ExecutorService threadPool = Executors.newFixedThreadPool(threads);
        try {
            List<Future<DecodedFile>> files = new ArrayList<>();
            for (String name : names) {
                files.add(threadPool.submit(() -> DecodedFile.of(name, kind)));
            }
            int status = ExitStatus.OK;
            for (Future<DecodedFile> file : files) {
                status = Math.max(status, print(file.get(), out, err));
            }
            return status;
        } finally {
            threadPool.shutdownNow();
        }
    }

    private static int print(DecodedFile file, PrintStream out, PrintStream err) {
        if (file.error() != null) {
            err.println("simgsm-modem: " + file.error());
        }
        out.print(file.line());
        out.flush();
        return file.status();
    }
}
