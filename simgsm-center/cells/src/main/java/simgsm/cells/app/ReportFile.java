package simgsm.cells.app;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simgsm.cells.mobile.MobileEvent;
import simgsm.file.CsvLine;
import simgsm.file.FileErrors;

/** A CSV file with a line for each measurement report, written at once; without a file, nothing. */
public final class ReportFile implements Consumer<MobileEvent>, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(ReportFile.class.getName());
    private static final String HEADER = "time,number,cell,rxlev,rxqual,ta,neighbours";

    private final Path file;
    private BufferedWriter out;

    private ReportFile(Path file, BufferedWriter out) {
        this.file = file;
        this.out = out;
    }

    /** Replaces the file by one with the header only. @throws IOException naming the file */
    public static ReportFile to(Optional<Path> file) throws IOException {
        if (file.isEmpty()) {
            return new ReportFile(Path.of(""), null);
        }
        ReportFile reports =
                new ReportFile(file.get(), FileErrors.naming(file.get(), () -> Files.newBufferedWriter(file.get())));
        FileErrors.naming(file.get(), () -> reports.write(HEADER));
        return reports;
    }

    @Override
    public void accept(MobileEvent event) {
        if (out != null && event instanceof MobileEvent.Reported report) {
            try {
                write(line(report));
            } catch (IOException e) {
                LOG.log(System.Logger.Level.WARNING, "no more reports to {0}: {1}", file, e.getMessage());
                out = null;
            }
        }
    }

    private void write(String line) throws IOException {
        out.write(line + "\n");
        out.flush();
    }

    private static String line(MobileEvent.Reported report) {
        return CsvLine.of(List.of(
                Instant.now().truncatedTo(ChronoUnit.MILLIS).toString(),
                report.mobile().number(),
                report.serving().cell(),
                Integer.toString(report.serving().rxlev()),
                Integer.toString(report.quality()),
                Integer.toString(report.timingAdvance()),
                report.neighbours().stream().map(Object::toString).collect(Collectors.joining(","))));
    }

    @Override
    public void close() throws IOException {
        if (out != null) {
            out.close();
        }
    }
}
