package simgsm.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** The texts of file errors: the file's name, then the fault. */
public final class FileErrors {
    /** Reads or writes a file. */
    public interface Work<T> {
        T perform() throws IOException;
    }

    /** Reads or writes a file, without a result. */
    public interface Action {
        void perform() throws IOException;
    }

    private FileErrors() {}

    /**
     * The result of reading or writing a file. The Java library omits the name if the file is open already (full
     * disk) or is a folder that is read.
     *
     * @throws IOException naming the file
     */
    public static <T> T naming(Path file, Work<T> work) throws IOException {
        try {
            return work.perform();
        } catch (FileSystemException e) {
            throw e;
        } catch (UncheckedIOException e) {
            throw named(file, e.getCause());
        } catch (IOException e) {
            throw named(file, e);
        }
    }

    /** As above, without a result. */
    public static void naming(Path file, Action action) throws IOException {
        naming(file, () -> {
            action.perform();
            return null;
        });
    }

    private static IOException named(Path file, IOException e) {
        String text = String.valueOf(e.getMessage());
        if (e instanceof FileSystemException || text.contains(file.toString())) {
            return e;
        }
        FileSystemException named = new FileSystemException(file.toString(), null, text);
        named.initCause(e);
        return named;
    }

    /**
     * Fails early if a file cannot be written; an existing file is not changed.
     *
     * @throws IOException naming the file
     */
    public static void requireWritable(Path file) throws IOException {
        boolean isNew = Files.notExists(file);
        naming(
                file,
                () -> Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND)
                        .close());
        if (isNew) {
            Files.deleteIfExists(file);
        }
    }

    /** The text of an error for a user. */
    public static String describe(IOException e) {
        return e instanceof FileSystemException ofFile && ofFile.getFile() != null
                ? ofFile.getFile() + ": " + reason(ofFile)
                : e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }

    private static String reason(FileSystemException e) {
        if (e instanceof NoSuchFileException) {
            Path folder = Path.of(e.getFile()).toAbsolutePath().getParent();
            return folder == null || Files.isDirectory(folder) ? "no such file" : "no such folder " + folder;
        }
        if (e instanceof AccessDeniedException) {
            return "access denied";
        }
        if (e instanceof FileAlreadyExistsException) {
            return Files.isDirectory(Path.of(e.getFile()))
                    ? "there is a folder of that name"
                    : "there is a file of that name";
        }
        if (e instanceof NotDirectoryException) {
            return "expected a folder, found a file";
        }
        if (e.getReason() == null) {
            return "cannot be read or written";
        }
        return Files.isDirectory(Path.of(e.getFile())) && e.getReason().contains("directory")
                ? "expected a file, found a folder"
                : e.getReason();
    }
}
