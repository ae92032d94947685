package simrobot.app.batch;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simgsm.file.CsvLine;
import simgsm.file.FileErrors;
import simrobot.control.TrackSeries;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;

/** {@code --track FILE.csv}: the robots of a run every 0.1 s, from beginning to end. */
final class RunTrack implements AutoCloseable {
    static final String HEADER = "robot,time,x,y,heading,status";

    private final Path file;
    private final Simulation simulation;
    private final BufferedWriter out;

    /** Writes the header and the robots' start. */
    RunTrack(Path file, Simulation simulation) throws IOException {
        this.simulation = simulation;
        this.file = file;
        out = Files.newBufferedWriter(file);
        out.write(HEADER + "\n");
        write(simulation.timeNanos());
    }

    /** Listens to the steps of the simulation. */
    void stepped(long timeNanos) {
        if (timeNanos % TrackSeries.PERIOD_NANOS == 0) {
            try {
                write(timeNanos);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    private void write(long timeNanos) throws IOException {
        FileErrors.naming(file, () -> writeRows(timeNanos));
    }

    private void writeRows(long timeNanos) throws IOException {
        for (SimulatedRobot robot : simulation.robots()) {
            out.write(CsvLine.of(List.of(robot.name(), "")));
            TrackSeries.writeRow(out, timeNanos, robot.pose(), robot.status());
        }
    }

    @Override
    public void close() throws IOException {
        FileErrors.naming(file, out::close);
    }
}
