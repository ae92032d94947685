package simgsm.center.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JToolTip;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;

@ExtendWith(OnEventThread.class)
class RowsPanelTest {
    private static final String TEXT = "<html><img src='http://127.0.0.1:9/x'>hello";

    @BeforeAll
    static void asInTheProgram() {
        Theme.install(Appearance.LIGHT);
    }

    @Test
    void aMessageThatBeginsAsAPageIsShownAsItsText() {
        RowsPanel<String> panel =
                new RowsPanel<>("rows", "Rows", "none", List.of(new Column<>("Text", 90, text -> text)));
        panel.show(List.of(TEXT));
        JTable table =
                (JTable) ((JScrollPane) panel.getComponent(0)).getViewport().getView();

        JLabel cell = (JLabel) table.prepareRenderer(table.getCellRenderer(0, 0), 0, 0);
        JToolTip tip = table.createToolTip();
        tip.setTipText(cell.getToolTipText());

        assertEquals(TEXT, cell.getText());
        assertNull(cell.getClientProperty(BasicHTML.propertyKey));
        assertNull(tip.getClientProperty(BasicHTML.propertyKey));
    }
}
