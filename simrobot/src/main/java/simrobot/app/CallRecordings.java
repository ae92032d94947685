package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import simgsm.speech.CallAudioListener;
import simgsm.speech.CallRecorder;
import simrobot.control.Fleet;

/** Where each robot's calls are recorded. */
public final class CallRecordings implements Fleet.Recording {
    private final Optional<Path> file;
    private boolean named;

    /** @param alone the first robot's calls go into the file itself; of several robots each has its name before the ending */
    public CallRecordings(Optional<Path> file, boolean alone) {
        this.file = file;
        named = !alone;
    }

    @Override
    public synchronized CallAudioListener of(String robot) throws IOException {
        if (file.isEmpty()) {
            return CallAudioListener.NONE;
        }
        Path path = named ? pathOf(file.get(), robot) : file.get();
        named = true;
        return CallRecorder.open(path);
    }

    /** With the robot's name before the ending. */
    static Path pathOf(Path file, String robot) {
        if (file.getFileName() == null) {
            return file;
        }
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        int end = dot > 0 ? dot : name.length();
        return file.resolveSibling(name.substring(0, end) + "-" + robot + name.substring(end));
    }
}
