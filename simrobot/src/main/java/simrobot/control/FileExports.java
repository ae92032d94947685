package simrobot.control;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import simgsm.file.FileReplacement;
import simrobot.simulation.SimulationSnapshot;

/** Writes pictures of the world and tracks of robots to files; the file name's extension selects the format. */
public final class FileExports {
    /** Draws the world with its robots; implemented by the windows. */
    public interface Pictures {
        /**
         * The content of a picture file.
         *
         * @param ending png or svg
         * @param selected the robot drawn as selected
         */
        byte[] of(SimulationSnapshot scene, String selected, String ending) throws IOException;
    }

    /** The tracks of the robots. */
    public interface Tracks {
        /** A robot's track with a header line, as by {@link TrackSeries.Samples#writeCsv}. */
        String csv(String robot) throws IOException;
    }

    private final Tracks tracks;
    private final Pictures pictures;

    public FileExports(Tracks tracks, Pictures pictures) {
        this.tracks = tracks;
        this.pictures = pictures;
    }

    /** True if the extension is png, svg or csv. */
    public static boolean hasKnownEnding(Path file) {
        return isPicture(file) || ending(file).equals("csv");
    }

    private static boolean isPicture(Path file) {
        return ending(file).equals("png") || ending(file).equals("svg");
    }

    /** Returns the extension in lower case, without the dot. */
    private static String ending(Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /**
     * Writes a file: for png and svg the world with its robots and trails, for csv the robot's track.
     *
     * @throws IOException if the file cannot be written; the message says which and why
     */
    public void export(SimulationSnapshot scene, String robot, Path file) throws IOException {
        write(content(scene, robot, file), file);
    }

    /**
     * Exports without blocking the caller: pictures are painted at once, because the event thread owns the colours; the
     * worker formats tracks and writes all files.
     *
     * @param answer receives the failure, if any, on either thread
     */
    public void export(
            SimulationSnapshot scene,
            String robot,
            Path file,
            Executor worker,
            Consumer<Optional<IOException>> answer) {
        try {
            byte[] picture = isPicture(file) ? content(scene, robot, file) : null;
            worker.execute(() -> {
                try {
                    write(picture == null ? content(scene, robot, file) : picture, file);
                    answer.accept(Optional.empty());
                } catch (IOException e) {
                    answer.accept(Optional.of(e));
                }
            });
        } catch (IOException e) {
            answer.accept(Optional.of(e));
        }
    }

    private byte[] content(SimulationSnapshot scene, String robot, Path file) throws IOException {
        return isPicture(file)
                ? pictures.of(scene, robot, ending(file))
                : tracks.csv(robot).getBytes(StandardCharsets.UTF_8);
    }

    private static void write(byte[] octets, Path file) throws IOException {
        try {
            FileReplacement.write(file, octets);
        } catch (NoSuchFileException e) {
            throw new IOException(file + " cannot be written, expected a folder that is there", e);
        } catch (AccessDeniedException e) {
            throw new IOException(file + " cannot be written: no permission", e);
        } catch (FileSystemException e) {
            String why = Files.isDirectory(file) ? "it is a folder" : String.valueOf(e.getReason());
            throw new IOException(file + " cannot be written: " + why, e);
        }
    }
}
