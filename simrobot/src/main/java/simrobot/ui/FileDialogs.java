package simrobot.ui;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JOptionPane;
import simgsm.console.TextBundle;
import simgsm.ui.file.SaveDialog;

/** Dialogs for saving files and unsaved changes. */
public final class FileDialogs {
    private FileDialogs() {}

    /**
     * Asks for the file to save to; an existing file is returned only after the user has agreed to replace it.
     *
     * @param filter description of the listed files
     * @param ending of the files, without the dot
     */
    public static Optional<Path> save(TextBundle texts, Component owner, Path proposal, String filter, String ending) {
        SaveDialog.Replacing replacing = new SaveDialog.Replacing(
                name -> texts.of("editor.replace", name),
                texts.of("editor.saveAs"),
                texts.of("editor.replace.yes"),
                texts.of("editor.cancel"));
        return SaveDialog.ask(
                owner, proposal, List.of(new SaveDialog.Kind(filter, ending)), FileDialogs::base, replacing);
    }

    /** Appends the extension; it replaces that of a Saphira world, which is never written. */
    public static Path withEnding(Path file, String ending) {
        return SaveDialog.withEnding(file, ending, FileDialogs::base);
    }

    private static String base(String name) {
        return name.replaceFirst("(?i)\\.(wld|yaml|yml|png|pgm)$", "");
    }

    /** The user's decision about unsaved changes of the editor. */
    public enum UnsavedChoice {
        SAVE,
        DROP,
        STAY
    }

    /** Asks about unsaved changes; a closed dialog is STAY. */
    public static UnsavedChoice askAboutChanges(TextBundle texts, Component owner, String world) {
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
        return answer < 0 ? UnsavedChoice.STAY : UnsavedChoice.values()[answer];
    }
}
