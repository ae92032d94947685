package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Rows, columns, names and acts. */
class ArrangeTest {
    private static JPanel box(int width, int height) {
        JPanel box = new JPanel(null);
        box.setPreferredSize(new Dimension(width, height));
        return box;
    }

    @AfterEach
    void asItWas() {
        Theme.zoomTo(1);
    }

    @Test
    void aRowStandsSideBySideWithGaps() {
        JPanel row = Arrange.row(8, box(10, 20), box(30, 5));
        assertEquals(new Dimension(48, 20), row.getPreferredSize());
        row.setSize(48, 20);
        row.doLayout();
        assertEquals(18, row.getComponent(1).getX());
        assertEquals(20, row.getComponent(1).getHeight());
    }

    @Test
    void gapsGrowWithTheZoom() {
        JPanel column = Arrange.column(8, box(10, 20), box(30, 5));
        Theme.zoomTo(2);
        assertEquals(new Dimension(30, 41), column.getPreferredSize());
    }

    @Test
    void whatGrowsTakesTheRoomThatIsLeft() {
        JPanel row = Arrange.row(0, box(10, 10), Arrange.spring(), box(10, 10));
        row.setSize(100, 10);
        row.doLayout();
        assertEquals(90, row.getComponent(2).getX());
    }

    @Test
    void whatIsHiddenTakesNoRoom() {
        JPanel row = Arrange.row(8, box(10, 10), box(10, 10));
        row.getComponent(0).setVisible(false);
        assertEquals(10, row.getPreferredSize().width);
    }

    @Test
    void aComponentIsFoundByItsName() {
        JLabel label = ComponentNames.name(new JLabel("x"), "status", "Status");
        JPanel panel = Arrange.row(0, Arrange.column(0, label));
        assertEquals(label, ComponentNames.find(panel, "status").orElseThrow());
        assertTrue(ComponentNames.find(panel, "nothing").isEmpty());
        assertEquals("Status", label.getAccessibleContext().getAccessibleName());
    }

    @Test
    void anActIsReachedByItsKeyAndDoesNothingWhileDisabled() {
        List<String> done = new ArrayList<>();
        JPanel panel = new JPanel();
        UserAction act = new UserAction("world.fit", "&Fit", () -> done.add("fit"));
        act.bindInWindow(panel, KeyStroke.getKeyStroke('f'));
        Object binding = panel.getInputMap(JPanel.WHEN_IN_FOCUSED_WINDOW).get(KeyStroke.getKeyStroke('f'));
        panel.getActionMap().get(binding).actionPerformed(null);
        act.setEnabled(false);
        panel.getActionMap().get(binding).actionPerformed(null);
        assertEquals(List.of("fit"), done);
        assertEquals("Fit", act.getValue(UserAction.NAME));
        assertEquals((int) 'F', act.getValue(UserAction.MNEMONIC_KEY));
    }

    @Test
    void theNewestSnapshotIsShownOnceAndOnlyWhenItChanged() {
        List<String> shown = new ArrayList<>();
        String[] source = {"a"};
        SnapshotPoller<String> newest = new SnapshotPoller<>(() -> source[0], shown::add);
        newest.show();
        newest.show();
        source[0] = "b";
        newest.show();
        assertEquals(List.of("a", "b"), shown);
    }
}
