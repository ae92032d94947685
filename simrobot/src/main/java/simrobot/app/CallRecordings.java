package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import simgsm.speech.CallAudioListener;
import simgsm.speech.CallRecorder;
import simrobot.control.Fleet;

/** Opens the WAV files of recorded calls. */
public final class CallRecordings implements Fleet.CallRecorders {
    private final Optional<Path> file;
    private boolean named;

    /** @param single true if the file is the only robot's; otherwise each robot's name is added before the extension */
    public CallRecordings(Optional<Path> file, boolean single) {
        this.file = file;
        named = !single;
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

    /** Adds the robot's name before the extension. */
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
