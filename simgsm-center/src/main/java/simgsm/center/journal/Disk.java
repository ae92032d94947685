package simgsm.center.journal;

import java.io.IOException;
import java.util.Set;

/**
 * A journal's directory. A change is durable after synchronisation: of contents by {@link DiskFile#sync}, of names by {@link
 * #sync}.
 */
public interface Disk {
    /** Names of all files. */
    Set<String> names() throws IOException;

    /** Creates an empty file; an existing file of this name is truncated. */
    DiskFile create(String name) throws IOException;

    /** Opens an existing file for reading and writing. */
    DiskFile open(String name) throws IOException;

    /** Renames atomically: after a crash the file has the one name or the other. */
    void rename(String from, String to) throws IOException;

    void delete(String name) throws IOException;

    /** Makes all names durable. */
    void sync() throws IOException;
}
