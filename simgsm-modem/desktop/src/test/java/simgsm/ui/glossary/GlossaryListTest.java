package simgsm.ui.glossary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.util.Locale;
import javax.swing.JEditorPane;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import javax.swing.text.StyleConstants;
import javax.swing.text.StyledDocument;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.ui.ComponentNames;

/** The list of terms, laid out without a display. */
class GlossaryListTest {
    @ParameterizedTest
    @CsvSource({"en, Find a term", "es, Buscar un t\u00e9rmino"})
    void beginsWithTheFirstTermBelowALabelledField(String language, String words) throws Exception {
        GlossaryList[] made = new GlossaryList[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = new GlossaryList(Locale.forLanguageTag(language));
            made[0].setSize(400, 300);
            layOut(made[0]);
        });
        JTextField wanted =
                (JTextField) ComponentNames.find(made[0], "glossary.find").orElseThrow();
        SwingUtilities.invokeAndWait(() -> {
            wanted.setText("e");
            layOut(made[0]);
            wanted.setText("");
            layOut(made[0]);
        });
        // What the text has asked for meanwhile comes first.
        SwingUtilities.invokeAndWait(() -> {});
        Component text = ComponentNames.find(made[0], "glossary.text").orElseThrow();
        assertTrue(text.getHeight() > 1000, text.getBounds().toString());
        JViewport view = (JViewport) SwingUtilities.getAncestorOfClass(JViewport.class, text);
        assertEquals(new Point(0, 0), view.getViewPosition());
        JLabel label = (JLabel) wanted.getClientProperty("labeledBy");
        assertEquals(words, label.getText());
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void termsAreBoldAndExplanationsAreNot(String language) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            GlossaryList list = new GlossaryList(Locale.forLanguageTag(language));
            JEditorPane text =
                    (JEditorPane) ComponentNames.find(list, "glossary.text").orElseThrow();
            assertTrue(isBold(text, "Abis"));
            assertFalse(isBold(text, "TS 48.058"));
        });
    }

    private static boolean isBold(JEditorPane text, String word) {
        StyledDocument document = (StyledDocument) text.getDocument();
        try {
            int at = document.getText(0, document.getLength()).indexOf(word);
            return StyleConstants.isBold(document.getCharacterElement(at).getAttributes());
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }
}
