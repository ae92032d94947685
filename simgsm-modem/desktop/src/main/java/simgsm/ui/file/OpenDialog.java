package simgsm.ui.file;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for a file to read. */
public final class OpenDialog {
    private OpenDialog() {}

    /**
     * A dialog not yet shown.
     *
     * @param start folder to show; empty for the last choice's
     * @param description of the expected files
     * @param endings of these files, without the dot; none for files of any kind. The user can show others
     */
    public static JFileChooser question(Optional<Path> start, String description, List<String> endings) {
        JFileChooser question = new FileQuestion(start);
        if (!endings.isEmpty()) {
            question.setFileFilter(new FileNameExtensionFilter(description, endings.toArray(String[]::new)));
        }
        return question;
    }

    /** Shows the dialog. @return the file; empty if the user has cancelled */
    public static Optional<Path> ask(Component owner, JFileChooser question) {
        return question.showOpenDialog(owner) == JFileChooser.APPROVE_OPTION
                ? Optional.of(FileQuestion.chosen(question))
                : Optional.empty();
    }
}
