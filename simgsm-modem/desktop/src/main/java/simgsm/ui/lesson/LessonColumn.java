package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;
import simgsm.ui.Theme;

/** A column of wrapping texts in a scroll pane: as wide as the view, as high as its texts. */
final class LessonColumn extends JPanel implements Scrollable {
    LessonColumn(JComponent content) {
        super(new BorderLayout());
        setOpaque(false);
        add(content, BorderLayout.CENTER);
    }

    /** The texts' height depends on their width, which each layout makes known to one level more. */
    @Override
    public void doLayout() {
        int before = getPreferredSize().height;
        super.doLayout();
        SwingUtilities.invokeLater(() -> {
            if (getPreferredSize().height != before) {
                revalidate();
            }
        });
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return Theme.px(20);
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return visible.height;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() > getPreferredSize().height;
    }
}
