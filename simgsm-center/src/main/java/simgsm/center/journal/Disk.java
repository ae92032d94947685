package simgsm.center.journal;

import java.io.IOException;
import java.util.Set;

/** The one directory that a journal lives in. Nothing is durable before it is synchronised: contents by the file, names here. */
public interface Disk {
    /** Names of the files that are there. */
    Set<String> names() throws IOException;

    /** A new, empty file, in place of an old one if need be. */
    DiskFile create(String name) throws IOException;

    /** A file that is there, for reading and writing. */
    DiskFile open(String name) throws IOException;

    /** Atomic: afterwards, and after a crash, there is the one name or the other. */
    void rename(String from, String to) throws IOException;

    void delete(String name) throws IOException;

    /** Makes all names durable. */
    void sync() throws IOException;
}
