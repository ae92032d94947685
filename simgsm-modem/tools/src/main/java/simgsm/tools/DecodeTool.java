package simgsm.tools;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Options;
import simgsm.console.UsageException;

/** {@code decode FILE...}: keys out of sound, a line per file. */
final class DecodeTool implements Tool {
    @Override
    public String word() {
        return "decode";
    }

    @Override
    public Options options() {
        return new Options(
                        "java -jar simgsm-modem.jar decode FILE.wav... [options]",
                        "Prints path, TAB, the keys heard, TAB, when each was decided (milliseconds from the file's start).\n"
                                + "Reads any rate, channels (mixed) and sample format of WAV, AU and AIFF files.\n"
                                + "Ends with 1 if a file is no audio, with 74 if one cannot be read.")
                .flag(
                        "explain",
                        "after each file's line one for each candidate: key, from and to in ms, finding, reason")
                .value(
                        "receiver",
                        "likelihood|classic",
                        "the modem's own receiver, or eight Goertzel filters as in textbooks")
                .value("block", "102|205", "samples in a block of the classic receiver (102)")
                .arguments(Integer.MAX_VALUE);
    }

    @Override
    public int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        List<String> names = arguments.rest();
        if (names.isEmpty()) {
            throw new UsageException("missing FILE.wav");
        }
        HeardFile.Kind kind = new HeardFile.Kind(
                arguments.has("explain"),
                arguments.choice("receiver", "likelihood", "classic").equals("classic"),
                Integer.parseInt(arguments.choice("block", "102", "205")));
        if (names.size() == 1) {
            return say(HeardFile.of(names.get(0), kind), out, err);
        }
        int threads = Math.min(names.size(), Runtime.getRuntime().availableProcessors());
        ExecutorService ears = Executors.newFixedThreadPool(threads);
        try {
            List<Future<HeardFile>> files = new ArrayList<>();
            for (String name : names) {
                files.add(ears.submit(() -> HeardFile.of(name, kind)));
            }
            int status = ExitStatus.OK;
            for (Future<HeardFile> file : files) {
                status = Math.max(status, say(file.get(), out, err));
            }
            return status;
        } finally {
            ears.shutdownNow();
        }
    }

    private static int say(HeardFile heard, PrintStream out, PrintStream err) {
        if (heard.complaint() != null) {
            err.println("simgsm-modem: " + heard.complaint());
        }
        out.print(heard.line());
        out.flush();
        return heard.status();
    }
}
