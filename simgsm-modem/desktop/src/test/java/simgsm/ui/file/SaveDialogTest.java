package simgsm.ui.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which file is written by what was typed and which kind was chosen. */
class SaveDialogTest {
    private static final List<SaveDialog.Kind> KINDS =
            List.of(new SaveDialog.Kind("Text", "txt"), new SaveDialog.Kind("Picture", "svg"));

    @ParameterizedTest
    @CsvSource({
        "lad.svg, txt, lad.svg",
        "lad.SVG, txt, lad.SVG",
        "lad.txt, svg, lad.txt",
        "lad, txt, lad.txt",
        "lad, svg, lad.svg",
        "lad.png, svg, lad.png.svg"
    })
    void theEndingThatWasTypedDecidesWhereItIsAKindsOwn(String typed, String chosen, String written) {
        assertEquals(Path.of(written), SaveDialog.named(Path.of(typed), chosen, KINDS, UnaryOperator.identity()));
    }
}
