package simgsm.center.ui.ladder;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.file.FileReplacement;
import simgsm.ui.file.SaveDialog;

/** Saves the visible messages as text or as a picture in a file chosen by the user. */
final class LadderSaving {
    private static final String TEXT = "txt";
    private static final String PICTURE = "svg";

    private final TextBundle texts;

    LadderSaving(TextBundle texts) {
        this.texts = texts;
    }

    void ask(JComponent owner, List<LadderRow> rows, Lifelines lifelines) {
        List<SaveDialog.Kind> kinds = List.of(
                new SaveDialog.Kind(texts.of("window.ladder.save.text"), TEXT),
                new SaveDialog.Kind(texts.of("window.ladder.save.picture"), PICTURE));
        SaveDialog.Replacing replacing = new SaveDialog.Replacing(
                name -> texts.of("window.ladder.save.replace", name),
                texts.of("window.ladder.save.title"),
                texts.of("window.ladder.save.yes"),
                texts.of("window.ladder.save.cancel"));
        SaveDialog.ask(owner, Path.of("ladder." + TEXT), kinds, UnaryOperator.identity(), replacing)
                .ifPresent(file -> save(owner, file, rows, lifelines));
    }

    private void save(JComponent owner, Path file, List<LadderRow> rows, Lifelines lifelines) {
        try {
            write(file, rows, lifelines);
        } catch (IOException e) {
            JOptionPane.showMessageDialog(
                    owner,
                    texts.of("window.ladder.save.failed", Program.describe(e)),
                    texts.of("window.ladder.save.title"),
                    JOptionPane.WARNING_MESSAGE);
        }
    }

    /** Writes a picture if the extension is svg, else text. */
    void write(Path file, List<LadderRow> rows, Lifelines lifelines) throws IOException {
        boolean isPicture = String.valueOf(file).toLowerCase(Locale.ROOT).endsWith("." + PICTURE);
        String text = isPicture
                ? LadderFile.svg(rows, lifelines, texts.of("window.ladder"))
                : LadderFile.text(rows, Locale.forLanguageTag(texts.of("window.language")));
        FileReplacement.write(file, text.getBytes(StandardCharsets.UTF_8));
    }
}
