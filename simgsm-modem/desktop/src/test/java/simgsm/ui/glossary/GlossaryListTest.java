package simgsm.ui.glossary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }
}
