package simgsm.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/**
 * Writes a file whole or not at all: a full disk, or the end of the program at any moment, leaves the old content.
 * Concurrent writers of the same file do not mix their octets; the last content stays.
 */
public final class FileReplacement {
    private static final boolean IS_WINDOWS = System.getProperty("os.name", "").startsWith("Windows");

    private FileReplacement() {}

    /**
     * Replaces the content of a file, or creates it. Of a symbolic link the target is replaced; a device or a pipe
     * stays, and the content is written to it.
     *
     * @throws FileSystemException naming a file that cannot be written, and the cause
     */
    public static void write(Path file, byte[] content) throws IOException {
        write(file, content, false);
    }

    /** As {@link #write}, for a file that only its owner may read. */
    public static void writePrivately(Path file, byte[] content) throws IOException {
        write(file, content, true);
    }

    /** As {@link #write}; content and name are on the disk when the method returns. */
    public static void writeDurably(Path file, byte[] content) throws IOException {
        write(file, content, false, StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.SYNC);
        syncFolder(file.toAbsolutePath().getParent());
    }

    /** Makes the names of a folder durable. Windows cannot open folders; NTFS makes names durable by itself. */
    public static void syncFolder(Path folder) throws IOException {
        if (!IS_WINDOWS) {
            try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
                channel.force(true);
            }
        }
    }

    private static void write(Path file, byte[] content, boolean isPrivate, OpenOption... options) throws IOException {
        Path target = Files.isSymbolicLink(file) ? file.toRealPath() : file;
        if (Files.isDirectory(target)) {
            throw new FileSystemException(file.toString(), null, "expected a file, found a folder");
        }
        if (Files.exists(target, LinkOption.NOFOLLOW_LINKS) && !Files.isWritable(target)) {
            throw new AccessDeniedException(file.toString(), null, "the file is write-protected");
        }
        if (Files.exists(target) && !Files.isRegularFile(target)) {
            FileErrors.naming(file, () -> Files.write(target, content));
            return;
        }
        Path folder = target.toAbsolutePath().getParent();
        if (!Files.isDirectory(folder)) {
            throw new NoSuchFileException(file.toString(), null, "the folder does not exist");
        }
        if (!Files.isWritable(folder)) {
            throw new AccessDeniedException(file.toString(), null, "the folder is write-protected");
        }
        // not Files.createTempFile: its files are readable by their owner only
        Path fresh = folder.resolve("." + target.getFileName() + "." + UUID.randomUUID() + ".new");
        try {
            if (isPrivate) {
                PrivateFiles.open(fresh, StandardOpenOption.CREATE, StandardOpenOption.WRITE)
                        .close();
            }
            FileErrors.naming(file, () -> Files.write(fresh, content, options));
            Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }
}
