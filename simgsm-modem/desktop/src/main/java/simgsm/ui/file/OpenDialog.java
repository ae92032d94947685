package simgsm.ui.file;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for a file that is to be read. */
public final class OpenDialog {
    private OpenDialog() {}

    /**
     * A dialog that is not shown yet.
     *
     * @param start the folder that is shown; empty for that of the last choice
     * @param description of the files that are expected
     * @param endings of these files, without the dot; none for files of any kind. Others are shown if the user says so
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
