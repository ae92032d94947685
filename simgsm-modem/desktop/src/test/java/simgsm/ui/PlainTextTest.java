package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertNull;

import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JToolTip;
import javax.swing.SwingUtilities;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.table.DefaultTableCellRenderer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.draw.Appearance;

class PlainTextTest {
    private static final String TEXT = "<html><b>5550100";

    @AfterEach
    void asBefore() {
        Theme.install(Appearance.LIGHT);
    }

    @ParameterizedTest
    @EnumSource
    void labelsCellsAndToolTipsShowMarkupLiterallyAlsoAfterAChangeOfAppearance(Appearance appearance) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            Theme.install(Appearance.LIGHT);
            JLabel label = new JLabel(TEXT);
            JToolTip tip = new JToolTip();
            tip.setTipText(TEXT);
            DefaultTableCellRenderer cell = new DefaultTableCellRenderer();
            cell.setText(TEXT);
            DefaultListCellRenderer row = new DefaultListCellRenderer();
            row.getListCellRendererComponent(new JList<>(), TEXT, 0, false, false);
            Theme.install(appearance);
            for (JComponent each : new JComponent[] {label, tip, cell, row}) {
                assertNull(
                        each.getClientProperty(BasicHTML.propertyKey),
                        each.getClass().getName());
                each.updateUI();
                assertNull(
                        each.getClientProperty(BasicHTML.propertyKey),
                        each.getClass().getName());
            }
        });
    }
}
