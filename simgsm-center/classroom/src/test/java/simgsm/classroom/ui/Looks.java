package simgsm.classroom.ui;

import java.awt.Component;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.JTable;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.text.StyleConstants;
import javax.swing.text.html.HTMLDocument;
import simgsm.ui.ComponentNames;

/** The colours and fonts of a window's components, to compare two windows. */
final class Looks {
    private Looks() {}

    static List<String> of(JComponent window) {
        return ComponentNames.all(window)
                .filter(each -> each.getName() != null || each == window)
                .map(Looks::look)
                .toList();
    }

    private static String look(Component component) {
        String look = component.getClass().getSimpleName() + " " + component.getName() + " " + component.getBackground()
                + " " + component.getForeground() + " " + component.getFont() + " "
                + (component instanceof JComponent it ? it.getInsets() : "");
        if (component instanceof JTable table && table.getRowCount() > 0) {
            JComponent cell = (JComponent) table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
            look += " markup " + cell.getClientProperty(BasicHTML.propertyKey);
        }
        if (component instanceof JEditorPane text && text.getDocument() instanceof HTMLDocument html) {
            var body = html.getStyleSheet().getRule("body");
            look += " " + StyleConstants.getFontFamily(body) + StyleConstants.getFontSize(body) + " "
                    + html.getStyleSheet().getForeground(body);
        }
        return look;
    }
}
