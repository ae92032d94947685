package simgsm.ui.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** What a file dialog shows when it opens. */
@Isolated("the last folder is one for the process")
class OpenDialogTest {
    @TempDir
    Path folder;

    private JFileChooser question;

    @BeforeEach
    void look() {
        Theme.install(Appearance.LIGHT);
    }

    private JFileChooser ask(Optional<Path> start, String... endings) throws Exception {
        SwingUtilities.invokeAndWait(() -> question = OpenDialog.question(start, "Sounds", List.of(endings)));
        return question;
    }

    @Test
    void theNameOfTheFileHasTheKeyboardFirst() throws Exception {
        JFileChooser opened = ask(Optional.of(folder), "wav");
        JTextField first = assertInstanceOf(
                JTextField.class, opened.getFocusTraversalPolicy().getDefaultComponent(opened));
        assertTrue(opened.isFocusTraversalPolicyProvider());
        SwingUtilities.invokeAndWait(
                () -> opened.setSelectedFile(folder.resolve("order.wav").toFile()));
        assertTrue(first.getText().endsWith("order.wav"), first.getText());
        FileQuestion.selectStem(first);
        assertTrue(first.getSelectedText().endsWith("order"), first.getSelectedText());
    }

    @Test
    void theExpectedFilesAreShownAndOthersIfTheUserSaysSo() throws Exception {
        JFileChooser opened = ask(Optional.of(folder), "wav");
        assertTrue(opened.getFileFilter().accept(Path.of("ORDER.WAV").toFile()));
        assertFalse(opened.getFileFilter().accept(Path.of("order.txt").toFile()));
        assertTrue(opened.getChoosableFileFilters().length > 1);
    }

    @Test
    void anyFileIsShownWhereNoKindIsExpected() throws Exception {
        assertTrue(ask(Optional.of(folder))
                .getFileFilter()
                .accept(Path.of("order.txt").toFile()));
    }

    @Test
    void theNextDialogShowsTheFolderOfTheLastChoice() throws Exception {
        Path chosen = Files.createDirectory(folder.resolve("chosen"));
        JFileChooser first = ask(Optional.of(folder));
        SwingUtilities.invokeAndWait(
                () -> first.setSelectedFile(chosen.resolve("order.wav").toFile()));
        FileQuestion.chosen(first);

        assertEquals(chosen.toFile(), ask(Optional.empty()).getCurrentDirectory());
        assertEquals(folder.toFile(), ask(Optional.of(folder)).getCurrentDirectory(), "a given folder comes first");
        Files.delete(chosen);
        assertFalse(LastFolder.get().isPresent(), "a folder that is gone is not shown");
    }

    @ParameterizedTest
    @CsvSource({"en, Look In:, Save In:", "es, Buscar en:, Guardar en:"})
    void aDialogAsksWhereToLookOrWhereToSave(String language, String look, String save) throws Exception {
        Locale before = JComponent.getDefaultLocale();
        JComponent.setDefaultLocale(Locale.forLanguageTag(language));
        try {
            SwingUtilities.invokeAndWait(() -> {
                FileQuestion dialog = new FileQuestion(Optional.empty());
                assertEquals(List.of(look), labels(dialog, look, save));
                dialog.askWhereToSave();
                assertEquals(List.of(save), labels(dialog, look, save));
            });
        } finally {
            JComponent.setDefaultLocale(before);
        }
    }

    private static List<String> labels(JFileChooser dialog, String... expected) {
        return ComponentNames.all(dialog)
                .filter(JLabel.class::isInstance)
                .map(label -> ((JLabel) label).getText())
                .filter(List.of(expected)::contains)
                .toList();
    }
}
