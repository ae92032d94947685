package simrobot.ui;

import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;
import simgsm.console.TextBundle;

/** Asks where a world is to be saved, and whether changes may be lost. */
public final class FileDialogs {
    private static final String ENDING = ".map";

    private FileDialogs() {}

    /** A {@code .map} that the person chose; one that is there only if it may be replaced. */
    public static Optional<Path> choose(TextBundle texts, Component owner, Path proposal) {
        Path folder = proposal.toAbsolutePath().getParent();
        JFileChooser chooser = new JFileChooser(folder == null ? null : folder.toFile());
        chooser.setSelectedFile(new File(withEnding(proposal).getFileName().toString()));
        chooser.setFileFilter(new FileNameExtensionFilter(texts.of("editor.files"), "map"));
        while (chooser.showSaveDialog(owner) == JFileChooser.APPROVE_OPTION) {
            Path file = withEnding(chooser.getSelectedFile().toPath());
            if (!Files.exists(file) || mayReplace(texts, owner, file)) {
                return Optional.of(file);
            }
        }
        return Optional.empty();
    }

    /** Only maps are written: a Saphira world is saved beside itself, as a map. */
    public static Path withEnding(Path file) {
        String name = String.valueOf(file.getFileName());
        if (name.toLowerCase(Locale.ROOT).endsWith(ENDING)) {
            return file;
        }
        return file.resolveSibling(name.replaceFirst("\\.(wld|WLD)$", "") + ENDING);
    }

    public static boolean mayReplace(TextBundle texts, Component owner, Path file) {
        Object[] answers = {texts.of("editor.replace.yes"), texts.of("editor.cancel")};
        return JOptionPane.showOptionDialog(
                        owner,
                        texts.of("editor.replace", file.getFileName()),
                        texts.of("editor.saveAs"),
                        JOptionPane.DEFAULT_OPTION,
                        JOptionPane.PLAIN_MESSAGE,
                        null,
                        answers,
                        answers[1])
                == 0;
    }

    /** What becomes of changes that are nowhere but in the editor. */
    public enum Leaving {
        SAVE,
        DROP,
        STAY
    }

    public static Leaving ask(TextBundle texts, Component owner, String world) {
        Object[] answers = {texts.of("editor.save"), texts.of("editor.drop"), texts.of("editor.cancel")};
        int answer = JOptionPane.showOptionDialog(
                owner,
                texts.of("editor.unsaved", world),
                texts.of("editor.title"),
                JOptionPane.DEFAULT_OPTION,
                JOptionPane.PLAIN_MESSAGE,
                null,
                answers,
                answers[0]);
        return answer == 0 ? Leaving.SAVE : answer == 1 ? Leaving.DROP : Leaving.STAY;
    }
}
