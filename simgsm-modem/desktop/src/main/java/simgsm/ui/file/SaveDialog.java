package simgsm.ui.file;

import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for a file to save, and before replacing one. */
public final class SaveDialog {
    private SaveDialog() {}

    /** A writable kind of files. @param ending without the dot */
    public record Kind(String description, String ending) {}

    /** The texts of the question. @param question for the name of the file */
    public record Replacing(Function<String, String> question, String title, String yes, String cancel) {}

    /**
     * Asks.
     *
     * @param kinds the first one is proposed
     * @param base removes the ending before a kind's own is appended
     * @return the file, with the ending of its kind; empty if the user has cancelled
     */
    public static Optional<Path> ask(
            Component owner, Path proposal, List<Kind> kinds, UnaryOperator<String> base, Replacing replacing) {
        FileQuestion chooser = new FileQuestion(Optional.ofNullable(proposal.getParent()));
        chooser.askWhereToSave();
        chooser.setAcceptAllFileFilterUsed(false);
        kinds.forEach(
                kind -> chooser.addChoosableFileFilter(new FileNameExtensionFilter(kind.description(), kind.ending())));
        chooser.setFileFilter(chooser.getChoosableFileFilters()[0]);
        Path proposed = withEnding(proposal, kinds.get(0).ending(), base);
        chooser.setSelectedFile(new File(proposed.getFileName().toString()));
        while (chooser.showSaveDialog(owner) == JFileChooser.APPROVE_OPTION) {
            Path chosen = FileQuestion.chosen(chooser);
            String ending = ((FileNameExtensionFilter) chooser.getFileFilter()).getExtensions()[0];
            Path file = named(chosen, ending, kinds, base);
            if (!Files.exists(file) || mayReplace(owner, file, replacing)) {
                return Optional.of(file);
            }
        }
        return Optional.empty();
    }

    /** The file by its typed ending if that is one of the kinds'; otherwise with the chosen kind's. */
    static Path named(Path typed, String chosenEnding, List<Kind> kinds, UnaryOperator<String> base) {
        return kinds.stream().anyMatch(kind -> hasEnding(typed, kind.ending()))
                ? typed
                : withEnding(typed, chosenEnding, base);
    }

    private static boolean hasEnding(Path file, String ending) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith("." + ending);
    }

    /** The base of the file with the ending. */
    public static Path withEnding(Path file, String ending, UnaryOperator<String> base) {
        return hasEnding(file, ending)
                ? file
                : file.resolveSibling(base.apply(String.valueOf(file.getFileName())) + "." + ending);
    }

    private static boolean mayReplace(Component owner, Path file, Replacing words) {
        Object[] answers = {words.yes(), words.cancel()};
        return JOptionPane.showOptionDialog(
                        owner,
                        words.question().apply(String.valueOf(file.getFileName())),
                        words.title(),
                        JOptionPane.DEFAULT_OPTION,
                        JOptionPane.PLAIN_MESSAGE,
                        null,
                        answers,
                        answers[1])
                == 0;
    }
}
