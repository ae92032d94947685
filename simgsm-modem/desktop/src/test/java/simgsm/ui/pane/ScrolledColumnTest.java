package simgsm.ui.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.Test;
import simgsm.ui.Arrange;

class ScrolledColumnTest {
    @Test
    void itScrollsToWhatGetsTheFocus() {
        JPanel[] parts = Stream.generate(JPanel::new).limit(5).toArray(JPanel[]::new);
        for (JPanel part : parts) {
            part.setPreferredSize(new Dimension(80, 100));
        }
        JPanel content = Arrange.column(0, parts);
        ScrolledColumn column = new ScrolledColumn(content);
        JScrollPane pane = new JScrollPane(column);
        pane.setSize(120, 150);
        for (int i = 0; i < 2; i++) {
            pane.doLayout();
            pane.getViewport().doLayout();
            column.doLayout();
            content.doLayout();
        }
        column.scrollTo(parts[4]);
        int top = pane.getViewport().getViewPosition().y;
        assertTrue(top > 300, "scrolled by " + top);
        column.scrollTo(parts[4]);
        assertEquals(top, pane.getViewport().getViewPosition().y);
        column.scrollTo(new JPanel());
        assertEquals(top, pane.getViewport().getViewPosition().y);
    }
}
