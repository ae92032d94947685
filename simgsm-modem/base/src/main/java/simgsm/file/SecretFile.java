package simgsm.file;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;

/** Files that hold passwords or keys. */
public final class SecretFile {
    private static final System.Logger LOG = System.getLogger(SecretFile.class.getName());

    private SecretFile() {}

    /** Logs a warning if every user of this machine may read the file. */
    public static void check(Path file) {
        if (isReadableByAll(file)) {
            LOG.log(
                    Level.WARNING,
                    "{0} holds secrets and every user of this machine may read it; \"chmod 600 {0}\" ends that",
                    file);
        }
    }

    /** False also on file systems without such permissions. */
    static boolean isReadableByAll(Path file) {
        try {
            return Files.getPosixFilePermissions(file).contains(PosixFilePermission.OTHERS_READ);
        } catch (IOException | UnsupportedOperationException e) {
            return false;
        }
    }
}
