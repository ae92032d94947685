package simrobot;

import java.nio.file.Path;

/** Where each robot's calls are recorded. */
final class Recordings {
    private Recordings() {}

    /** The file itself for a robot alone; of several robots each has its name before the ending. */
    static Path pathOf(Path file, String robot, int robots) {
        if (robots == 1 || file.getFileName() == null) {
            return file;
        }
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        int end = dot > 0 ? dot : name.length();
        return file.resolveSibling(name.substring(0, end) + "-" + robot + name.substring(end));
    }
}
