package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.center.ui.Scene;
import simgsm.console.TextBundle;

class LadderFileTest {
    private final List<LadderRow> rows = IntStream.range(0, Scene.everyKind().size())
            .mapToObj(i -> new LadderRow(i + 1, Scene.everyKind().get(i)))
            .toList();
    private final Lifelines lifelines = Lifelines.of(List.of("5550100", "5550200"));

    @Test
    void theTextHasEveryMessageWithItsFieldsAndOctets() {
        String text = LadderFile.text(rows, Locale.ROOT);

        assertTrue(text.contains("5550100 \u2192 M3 Setup\n    send sequence number  0\n"), text);
        assertTrue(text.contains("\n    0000  03 05 04 06"), text);
        assertTrue(text.contains("    text                  Attention"), text);
    }

    @Test
    void thePictureIsAnXmlDocumentWithTheNameOfEveryMessage() throws Exception {
        String svg = LadderFile.svg(rows, lifelines, "Ladder");
        var document = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
        var texts = document.getElementsByTagName("text");
        List<String> words = IntStream.range(0, texts.getLength())
                .mapToObj(i -> texts.item(i).getTextContent())
                .toList();

        assertEquals(List.of("5550100", "M3", "5550200"), words.subList(0, 3));
        for (LadderRow row : rows) {
            assertTrue(words.contains(row.entry().name()), words.toString());
        }
    }

    @Test
    void theEndingOfTheFileDecidesWhatIsWritten(@TempDir Path folder) throws IOException {
        LadderSaving saving =
                new LadderSaving(new TextBundle(ResourceBundle.getBundle("simgsm.center.app.messages"), Locale.ROOT));
        saving.write(folder.resolve("a.svg"), rows, lifelines);
        saving.write(folder.resolve("a.txt"), rows, lifelines);

        assertTrue(Files.readString(folder.resolve("a.svg")).startsWith("<?xml"));
        assertEquals(LadderFile.text(rows, Locale.ROOT), Files.readString(folder.resolve("a.txt")));
    }
}
