package simrobot.control;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import simrobot.simulation.SimulationSnapshot;

/** Writes pictures of the world and tracks of robots into files, by the file's ending. */
public final class FileExports {
    /** Draws the world with its robots; the one that can lives with the windows. */
    public interface Pictures {
        /**
         * The picture as a file of that kind holds it.
         *
         * @param ending png or svg
         * @param selected the robot in the middle of interest
         */
        byte[] of(SimulationSnapshot scene, String selected, String ending) throws IOException;
    }

    private final SimRobot simRobot;
    private final Pictures pictures;

    public FileExports(SimRobot simRobot, Pictures pictures) {
        this.simRobot = simRobot;
        this.pictures = pictures;
    }

    /** Whether the name says what the file is to hold. */
    public static boolean isNamedWell(Path file) {
        return switch (ending(file)) {
            case "png", "svg", "csv" -> true;
            default -> false;
        };
    }

    /** In small letters, without the dot. */
    public static String ending(Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** What the file is to hold: for .png and .svg the world with its robots and trails, for .csv the robot's track. */
    public byte[] octets(SimulationSnapshot scene, String robot, Path file) throws IOException {
        return ending(file).equals("csv")
                ? simRobot.tracks().csv(robot).getBytes(StandardCharsets.UTF_8)
                : pictures.of(scene, robot, ending(file));
    }

    /** @throws IOException saying which file cannot be written, and why */
    public static void write(byte[] octets, Path file) throws IOException {
        try {
            Files.write(file, octets);
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
