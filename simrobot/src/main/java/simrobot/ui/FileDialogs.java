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

/** The dialogs about files that are written: where to, and whether changes are saved. */
public final class FileDialogs {
    private FileDialogs() {}

    /**
     * Asks where a file is to be saved; an existing file is returned only after the user has agreed to replace it.
     *
     * @param filter description of the files that are shown
     * @param ending of the files, without the dot
     */
    public static Optional<Path> save(TextBundle texts, Component owner, Path proposal, String filter, String ending) {
        JFileChooser chooser = proposal.getParent() == null
                ? new JFileChooser()
                : new JFileChooser(proposal.getParent().toFile());
        chooser.setSelectedFile(
                new File(withEnding(proposal, ending).getFileName().toString()));
        chooser.setFileFilter(new FileNameExtensionFilter(filter, ending));
        while (chooser.showSaveDialog(owner) == JFileChooser.APPROVE_OPTION) {
            Path file = withEnding(chooser.getSelectedFile().toPath(), ending);
            if (!Files.exists(file) || mayReplace(texts, owner, file)) {
                return Optional.of(file);
            }
        }
        return Optional.empty();
    }

    /** With the ending; it replaces that of a Saphira world, which is never written. */
    public static Path withEnding(Path file, String ending) {
        String name = String.valueOf(file.getFileName());
        return name.toLowerCase(Locale.ROOT).endsWith("." + ending)
                ? file
                : file.resolveSibling(name.replaceFirst("(?i)\\.(wld|yaml|yml|png|pgm)$", "") + "." + ending);
    }

    private static boolean mayReplace(TextBundle texts, Component owner, Path file) {
        String question = texts.of("editor.replace", file.getFileName());
        return choose(
                        owner,
                        question,
                        texts.of("editor.saveAs"),
                        1,
                        texts.of("editor.replace.yes"),
                        texts.of("editor.cancel"))
                == 0;
    }

    /** @return the index of the chosen answer, or -1 */
    private static int choose(Component owner, String question, String title, int proposed, Object... answers) {
        return JOptionPane.showOptionDialog(
                owner,
                question,
                title,
                JOptionPane.DEFAULT_OPTION,
                JOptionPane.PLAIN_MESSAGE,
                null,
                answers,
                answers[proposed]);
    }

    /** What happens to unsaved changes of the editor. */
    public enum UnsavedChoice {
        SAVE,
        DROP,
        STAY
    }

    /** Asks what happens to unsaved changes; a closed dialog is STAY. */
    public static UnsavedChoice askAboutChanges(TextBundle texts, Component owner, String world) {
        int answer = choose(
                owner,
                texts.of("editor.unsaved", world),
                texts.of("editor.title"),
                0,
                texts.of("editor.save"),
                texts.of("editor.drop"),
                texts.of("editor.cancel"));
        return answer < 0 ? UnsavedChoice.STAY : UnsavedChoice.values()[answer];
    }
}
