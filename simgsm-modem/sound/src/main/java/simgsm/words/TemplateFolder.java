package simgsm.words;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;

/** A speaker's templates as files {@code WORD.N.word} of a folder, N from 1. */
public final class TemplateFolder {
    private static final String ENDING = ".word";

    private final Path folder;

    public TemplateFolder(Path folder) {
        this.folder = folder;
    }

    /** @return no templates if there is no such folder @throws IOException naming a damaged file */
    public SpeakerTemplates read() throws IOException {
        SpeakerTemplates templates = new SpeakerTemplates();
        for (Path file : files()) {
            try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
                String name = file.getFileName().toString();
                templates.add(name.substring(0, name.indexOf('.')), SpokenWord.read(in));
            } catch (IOException e) {
                throw new IOException(file + ": " + e.getMessage(), e);
            }
        }
        return templates;
    }

    private List<Path> files() throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().matches("[^.]+\\.[0-9]+\\" + ENDING))
                    .sorted()
                    .toList();
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /**
     * Adds a template; a missing folder is created.
     *
     * @param word letters, digits and hyphens
     * @param number from 1; over {@link SpeakerTemplates#MOST} the word's first template is deleted
     * @return the number in the folder
     */
    public int add(String word, int number, SpokenWord template) throws IOException {
        Files.createDirectories(folder);
        for (int i = 1; number > SpeakerTemplates.MOST && i < SpeakerTemplates.MOST; i++) {
            Files.move(file(word, i + 1), file(word, i), StandardCopyOption.REPLACE_EXISTING);
        }
        int kept = Math.min(number, SpeakerTemplates.MOST);
        try (DataOutputStream out =
                new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file(word, kept))))) {
            template.write(out);
        }
        return kept;
    }

    private Path file(String word, int number) {
        return folder.resolve(word + "." + number + ENDING);
    }
}
